#include "search/spatial_order.h"

#include <algorithm>

#include "core/morton_code.h"

namespace tank_datum {
std::vector<std::uint32_t> mortonOrder(const Points& points) {
  if (points.empty()) return {};
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  const double scale = extent > 0.0 ? static_cast<double>((1ULL << kMortonBits) - 1) / extent : 0.0;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d cell = (points[i] - low) * scale;
    keys[i].first = mortonCode(static_cast<std::uint64_t>(cell.x()), static_cast<std::uint64_t>(cell.y()),
                               static_cast<std::uint64_t>(cell.z()));
    keys[i].second = static_cast<std::uint32_t>(i);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace tank_datum
