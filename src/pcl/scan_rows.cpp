#include <functional>
#include <stdexcept>
#include <unordered_map>

#include "tank_datum/pcl/pcl_stages.h"

namespace tank_datum {
namespace {

struct HashOfPoint {
  std::size_t operator()(const Eigen::Vector3d& p) const {
    const std::hash<double> hash;
    return (hash(p.x()) * 31 + hash(p.y())) * 31 + hash(p.z());
  }
};

}  // namespace

std::vector<std::size_t> rowsOf(const Points& points, const Scan& scan) {
  std::unordered_multimap<Eigen::Vector3d, std::size_t, HashOfPoint> wanted(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) wanted.emplace(points[i], i);
  std::vector<std::size_t> rows(points.size());
  std::size_t row = 0;
  scan.forEachBlock([&](const Points& block) {
    for (const auto& p : block) {
      const auto found = wanted.find(p);
      if (found != wanted.end()) {
        rows[found->second] = row;
        wanted.erase(found);
      }
      ++row;
    }
  });
  if (!wanted.empty()) throw std::logic_error("rowsOf: a point that is not the scan's");
  return rows;
}

}  // namespace tank_datum
