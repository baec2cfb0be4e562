#include "setups/rounded_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/point_hash.h"
#include "core/rounding_step.h"
#include "setups/turned_grid.h"

namespace tank_datum {
namespace {

/// Evenly between 0 and 1, the same of the same point, and another one for each use.
double evenly(std::uint32_t hash, std::uint64_t use) {
  const std::uint64_t bits = mixed(hash + (use + 1) * 0x9e3779b97f4a7c15ULL) >> 11;
  return static_cast<double>(bits) * 0x1.0p-53;
}

/// Whether a step is a power of two, as float32 leaves of large coordinates: each axis has its own then, z often none.
bool isOfFloats(double step) {
  constexpr double kOff = 0.005;  // decimal steps differ from powers of two by 0.02 and more
  int exponent = 0;
  return std::abs(std::remainder(std::frexp(step, &exponent), 0.5)) < kOff;
}

std::vector<double> valuesOf(const Points& points, Eigen::Index axis) {
  std::vector<double> values;
  for (const auto& p : points) values.push_back(p[axis]);
  return values;
}

/// The steps of the coordinates of every setup; 0 where they are finer than `finest`. Where others are rounded and z is
/// not, the scan was turned since: z has theirs, unseen.
std::vector<Eigen::Vector3d> stepsOf(const Ring& ring, double finest) {
  constexpr double kPlenty = 20'000.0;    // points of a setup, whatever their order
  constexpr std::size_t kMany = 16;       // setups, of which each has a smaller sample
  constexpr std::uint64_t kToSample = 3;  // beside the axes: a ring that was thinned by hashes has low ones only
  std::vector<Points> samples(ring.setupCount());
  const double plenty = kPlenty * static_cast<double>(std::min(kMany, samples.size()));
  const double share = std::min(1.0, plenty / static_cast<double>(ring.points.size()));
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    if (evenly(pointHash(ring.points[i]), kToSample) < share) samples[ring.setupOf(i)].push_back(ring.points[i]);
  }
  std::vector<Eigen::Vector3d> steps(samples.size(), Eigen::Vector3d::Zero());
  for (std::size_t s = 0; s < steps.size(); ++s) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      steps[s][axis] = roundingStep(valuesOf(samples[s], axis), finest);
    }
    const double coarsest = steps[s].maxCoeff();
    if (steps[s].z() == 0.0 && !isOfFloats(coarsest)) steps[s].z() = coarsest;
    // means that a filter took of rounded elevations lie between the steps, and those of a floor on one of them
    const double beside_floor = roundingStepBesideFloor(valuesOf(samples[s], 2), finest);
    steps[s].z() = std::max(steps[s].z(), beside_floor);
    if (steps[s].head<2>().isZero()) steps[s].head<2>().setConstant(turnedGridStep(samples[s], finest));
  }
  return steps;
}

}  // namespace

void spreadRounded(Ring& ring, double unit) {
  constexpr double kFinest = 2e-4;  // smaller ones are lost in what scanners err by [m]
  const std::vector<Eigen::Vector3d> steps = stepsOf(ring, kFinest * unit);
  ring.rounding = 0.0;
  for (const Eigen::Vector3d& step : steps) ring.rounding = std::max(ring.rounding, step.z());
  if (std::all_of(steps.begin(), steps.end(), [](const Eigen::Vector3d& step) { return step.isZero(); })) return;
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    const Eigen::Vector3d& step = steps[ring.setupOf(i)];
    const std::uint32_t hash = pointHash(ring.points[i]);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      ring.points[i][axis] += step[axis] * (evenly(hash, static_cast<std::uint64_t>(axis)) - 0.5);
  }
}

}  // namespace tank_datum
