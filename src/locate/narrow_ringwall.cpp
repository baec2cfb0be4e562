#include "locate/narrow_ringwall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "fit/ring_cells.h"
#include "locate/foot_heights.h"
#include "locate/foot_unit.h"
#include "locate/step_back.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSectors = 120;
constexpr double kLayer = 0.02;  // heights that are looked at together [footUnit]

using SectorHits = std::vector<std::vector<Hit>>;

/// Adds what stands at the shell to its sector, by its height above the foot [footUnit].
void addHits(const Points& points, const Tank& tank, double unit, SectorHits& hits) {
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector2d arm = p.head<2>() - tank.circle.center;
    const double off = (arm.norm() - tank.circle.radius) / unit;
    if (std::abs(off) > kWidestFace + kNarrowestFace) continue;
    const double azimuth = tank.azimuthOf(p.head<2>());
    hits[ringCell(azimuth, kSectors)].push_back({(p.z() - tank.foot(azimuth)) / unit, off});
  }
}

/// How far the middle third of the face under a step stands out of the lowest and the highest.
double bulgeOf(const std::vector<Hit>& hits, const StepBack& step) {
  std::array<std::vector<double>, 3> thirds;
  for (const Hit& hit : hits) {
    const double part = 3.0 * (hit.z - step.bottom) / (step.height - step.bottom);
    if (part >= 0.0 && part < 3.0 && hit.off > step.off + 0.5 * step.width)
      thirds[static_cast<std::size_t>(part)].push_back(hit.off);
  }
  const double lowest = median(std::move(thirds[0])), highest = median(std::move(thirds[2]));
  return median(std::move(thirds[1])) - 0.5 * (lowest + highest);
}

/// The step of a wall whose face below it is as straight as the shell above.
StepBack narrowStep(const std::vector<Hit>& hits) {
  constexpr double kScatter = 0.1;  // of its width
  constexpr double kBulge = 0.03;   // a pipe along the foot is round, and bulges by twice as much and more
  const StepBack step = findStepBack(hits, kLayer, kNarrowestFace);
  const bool is_narrow = step.found() && step.width <= kWidestFace && step.scatter <= kScatter * step.width;
  return is_narrow && !(bulgeOf(hits, step) > kBulge * step.width) ? step : StepBack{};
}

/// Whether a wall is seen on both sides of a height, on one line.
bool goesPast(const std::vector<Hit>& hits, double height) {
  constexpr double kPiece = kFewestVoxels * kLayer;
  std::vector<double> below, above;
  for (const Hit& hit : hits) {
    if (hit.z > height - 2.0 * kPiece && hit.z < height - kPiece) below.push_back(hit.off);
    if (hit.z > height + kPiece && hit.z < height + 2.0 * kPiece) above.push_back(hit.off);
  }
  if (below.empty() || above.empty()) return false;
  return std::abs(median(std::move(below)) - median(std::move(above))) < kNarrowestFace;
}

}  // namespace

std::optional<Tank> onNarrowRingwall(const Ring& ring, const Points& above, const Tank& tank) {
  constexpr double kFewest = 0.25;  // of the sectors in which a wall is seen: fewer may be things that stand about
  if (!mayStandOnNarrowRingwall(tank)) return {};
  const double unit = footUnit(tank.circle.radius, tank.resolution);
  SectorHits hits(kSectors);
  addHits(ring.points, tank, unit, hits);
  addHits(above, tank, unit, hits);
  std::vector<StepBack> steps;
  for (const std::vector<Hit>& sector : hits) steps.push_back(narrowStep(sector));
  const double usual = medianOf(steps, [](const StepBack& step) { return step.height; });
  std::vector<double> feet;
  std::vector<Eigen::Vector2d> plan;
  std::size_t seen = 0, straight = 0;
  for (std::size_t i = 0; i < kSectors; ++i) {
    seen += !hits[i].empty();
    const double azimuth = middleOfCell(i, kSectors);
    feet.push_back(steps[i].found() ? tank.foot(azimuth) + unit * steps[i].height : kUnknown);
    const Eigen::Vector2d direction(portable::cos(azimuth), portable::sin(azimuth));
    if (steps[i].found()) {
      plan.push_back(tank.circle.center + (tank.circle.radius + unit * steps[i].off) * direction);
    } else if (goesPast(hits[i], usual)) {
      ++straight;
    }
  }
  if (plan.size() <= straight || static_cast<double>(plan.size()) < kFewest * static_cast<double>(seen)) return {};
  Tank raised = tank;
  raised.circle = fitCircleRobust(plan, tank.circle);
  raised.foot = fitFootHeights(feet, kLayer * unit, {kFewestVoxels * kLayer * unit, ring.reach});
  if (!raised.circle.valid() || !raised.foot.valid()) return {};
  raised.ringwall_width = unit * medianOf(steps, [](const StepBack& step) { return step.width; });
  raised.ringwall_height = unit * medianOf(steps, [](const StepBack& step) { return step.faceHeight(); });
  return raised;
}

}  // namespace tank_datum
