#include "io/point_extent.h"

#include <algorithm>
#include <cstddef>

namespace tank_datum {
namespace {

double quantileOf(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

bool Extent::holds(const Eigen::Vector3d& point) const {
  constexpr double kFurthest = 500.0;  // times the reach; of a scanner that reaches a kilometre, and stands 5 m away
  return (point - middle).cwiseAbs().maxCoeff() <= kFurthest * reach;
}

Extent extentOf(const Points& points) {
  constexpr double kTrusted = 0.4;  // of the points; less than half may be anywhere
  constexpr std::size_t kEnough = 20'000;
  const std::size_t stride = points.size() / kEnough + 1;
  std::vector<double> values;
  Extent extent;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (std::size_t i = 0; i < points.size(); i += stride) values.push_back(points[i][axis]);
    extent.middle[axis] = quantileOf(values, 0.5);
  }
  values.clear();
  for (std::size_t i = 0; i < points.size(); i += stride) {
    values.push_back((points[i] - extent.middle).cwiseAbs().maxCoeff());
  }
  extent.reach = quantileOf(values, kTrusted);
  return extent;
}

}  // namespace tank_datum
