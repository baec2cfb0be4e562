#include "setups/turned_grid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "core/statistics.h"

namespace tank_datum {
namespace {

/// From each of some places to the nearest one east of it.
std::vector<Eigen::Vector2d> toNearest(const std::vector<Eigen::Vector2d>& places) {
  std::vector<Eigen::Vector2d> steps;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    Eigen::Vector2d nearest = places[i + 1] - places[i];
    for (std::size_t j = i + 2; j < places.size() && places[j].x() - places[i].x() < nearest.norm(); ++j) {
      const Eigen::Vector2d step = places[j] - places[i];
      if (step.squaredNorm() < nearest.squaredNorm()) nearest = step;
    }
    steps.push_back(nearest);
  }
  return steps;
}

/// Whether the shortest of some steps lie along or across one direction.
bool areOfOneGrid(const std::vector<Eigen::Vector2d>& steps, double shortest) {
  constexpr double kSame = 0.02;     // of the step
  constexpr double kAligned = 0.95;  // mean of unit vectors at four times the directions
  std::complex<double> sum;
  double count = 0.0;
  for (const Eigen::Vector2d& step : steps) {
    if (std::abs(step.norm() - shortest) > kSame * shortest) continue;
    const std::complex<double> along(step.x() / step.norm(), step.y() / step.norm()), twice = along * along;
    sum += twice * twice, count += 1.0;
  }
  return std::abs(sum) > kAligned * count;
}

}  // namespace

double turnedGridStep(const Points& points, double finest) {
  constexpr double kShared = 0.05;     // of the points: of places that others have too
  constexpr double kNeighbours = 0.1;  // of the places, at least, have a neighbour a step away
  std::vector<Eigen::Vector2d> places;
  for (const auto& p : points) places.push_back(p.head<2>());
  std::sort(places.begin(), places.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  places.erase(std::unique(places.begin(), places.end()), places.end());
  const auto shared = static_cast<double>(points.size() - places.size());
  if (places.size() < 2 || shared < kShared * static_cast<double>(points.size())) return 0.0;
  const std::vector<Eigen::Vector2d> steps = toNearest(places);
  std::vector<double> lengths;
  for (const Eigen::Vector2d& step : steps) lengths.push_back(step.norm());
  const double shortest = quantile(std::move(lengths), kNeighbours);
  return shortest >= finest && areOfOneGrid(steps, shortest) ? shortest : 0.0;
}

}  // namespace tank_datum
