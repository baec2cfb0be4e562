#include "locate/locate.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/azimuth.h"
#include "core/parallel.h"
#include "core/parts.h"
#include "locate/circle_search.h"
#include "locate/nested_tanks.h"
#include "locate/ring_shape.h"
#include "locate/sample_ladder.h"
#include "locate/tank_description.h"
#include "locate/wall_map.h"
#include "locate/walls_behind.h"

namespace tank_datum {
namespace {

/// Of all rows, the not finite ones too.
double shareNearFoot(const Scan& scan, const Points& looked_at, const Tank& tank, int threads) {
  const RingShape shape(tank, Tank::kNear);
  const std::size_t near =
      countWhere(looked_at.size(), threads, [&](std::size_t i) { return shape.holds(looked_at[i]); });
  return static_cast<double>(near) * static_cast<double>(strideOf(scan.size())) / static_cast<double>(scan.size());
}

std::string degreesOf(double arc) { return std::to_string(std::lround(toDegrees(arc))) + " deg"; }

std::string whyTooShort(double coverage) {
  return "its wall reaches down to a foot over " + degreesOf(coverage) + " only";
}

/// What stands behind a tank whose foot is known.
void lookBehind(Tank& tank, const std::vector<WallCell>& walls) {
  if (!tank.foot.valid()) return;
  const WallsBehind behind = wallsBehind(walls, tank);
  tank.behind_share = behind.share;
  tank.behind = behind.distance;
}

/// The tanks of a sample, and the circles that are none.
struct Found {
  std::vector<Tank> tanks;
  std::vector<RejectedCircle> rejected;
};

Found tanksOf(const Sample& sample, const Points& looked_at, const LocateOptions& options) {
  const std::vector<WallCell> walls = mapWalls(sample.points, sample.voxel);
  Found all;
  for (const auto& found : findWallCircles(walls, sample.voxel, options)) {
    std::string reason = found.rejected;
    if (reason.empty()) {
      Tank tank = describe(sample.points, sample, found.circle, found.rms);
      // the ground may lie too thin for the sample, where one scanner sees it; of all points some lie anywhere by
      // chance
      constexpr double kOfAll = 0.5;
      if (!tank.has_foundation) tank = describe(looked_at, sample, found.circle, found.rms, kOfAll);
      lookBehind(tank, walls);
      if (tank.coverage >= options.min_arc || tank.standsOnRingwall()) {
        all.tanks.push_back(std::move(tank));
        continue;
      }
      reason = whyTooShort(tank.coverage);
    }
    all.rejected.push_back({found.circle, found.coverage, reason});
  }
  return all;
}

/// Of all samples.
Found tanksOf(const std::vector<Sample>& samples, const Points& looked_at, const LocateOptions& options, int threads) {
  std::vector<Found> found(samples.size());
  forEachIndex(samples.size(), threads, [&](std::size_t i) { found[i] = tanksOf(samples[i], looked_at, options); });
  Found all;
  for (Found& of_sample : found) {
    std::move(of_sample.tanks.begin(), of_sample.tanks.end(), std::back_inserter(all.tanks));
    std::move(of_sample.rejected.begin(), of_sample.rejected.end(), std::back_inserter(all.rejected));
  }
  return all;
}

/// Takes out the tanks of which too little is seen.
void rejectShort(Found& found, double min_arc) {
  const auto seen = std::stable_partition(found.tanks.begin(), found.tanks.end(),
                                          [&](const Tank& tank) { return tank.coverage >= min_arc; });
  for (auto tank = seen; tank != found.tanks.end(); ++tank)
    found.rejected.push_back({tank->circle, tank->coverage, whyTooShort(tank->coverage)});
  found.tanks.erase(seen, found.tanks.end());
}

bool holdStrays(const std::vector<Sample>& samples) {
  return std::any_of(samples.begin(), samples.end(), [](const Sample& sample) { return sample.strays; });
}

/// The tank on a known circle; its foot is not valid where the sample shows none.
Tank describeKnown(const std::vector<Sample>& samples, const Circle& circle) {
  if (samples.empty()) return {};
  const Sample& sample = samples.front();
  const double rms = std::max(sample.voxel, 0.005 * circle.radius);
  Tank tank = describe(sample.points, sample, circle, rms, kLeastFoundation, true);
  if (tank.foot.valid()) lookBehind(tank, mapWalls(sample.points, sample.voxel));
  return tank;
}

}  // namespace

double Tank::azimuthOf(const Eigen::Vector2d& p) const {
  return azimuthOfArm(p.x() - circle.center.x(), p.y() - circle.center.y());
}

std::vector<Tank> locateTanks(const Scan& scan, const LocateOptions& options, int threads,
                              std::vector<RejectedCircle>* rejected) {
  const Points looked_at = lookAt(scan, threads);
  const std::vector<Sample> samples = samplesOf(looked_at, options, threads);
  Found found = tanksOf(samples, looked_at, options, threads);
  if (found.tanks.empty() && holdStrays(samples))
    found = tanksOf(samplesOfAll(looked_at, options, threads), looked_at, options, threads);
  std::vector<Tank>& tanks = found.tanks;
  dropNested(tanks);
  rejectShort(found, options.min_arc);
  const auto longer = [](const auto& a, const auto& b) {
    return a.coverage * a.circle.radius > b.coverage * b.circle.radius;
  };
  std::sort(tanks.begin(), tanks.end(), longer);
  if (rejected) {
    *rejected = std::move(found.rejected);
    std::stable_sort(rejected->begin(), rejected->end(), longer);
  }
  for (Tank& tank : tanks) tank.near_foot = tank.foot.valid() ? shareNearFoot(scan, looked_at, tank, threads) : 0.0;
  return tanks;
}

std::optional<Tank> describeTank(const Scan& scan, const Circle& circle, const LocateOptions& options, int threads) {
  const Points looked_at = lookAt(scan, threads);
  const std::vector<Sample> samples = samplesOf(looked_at, options, threads);
  Tank tank = describeKnown(samples, circle);
  if (!tank.foot.valid() && holdStrays(samples))
    tank = describeKnown(samplesOfAll(looked_at, options, threads), circle);
  if (!tank.foot.valid()) return std::nullopt;
  tank.near_foot = shareNearFoot(scan, looked_at, tank, threads);
  return tank;
}

}  // namespace tank_datum
