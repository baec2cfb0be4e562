#include "locate/locate.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "fit/harmonics.h"
#include "io/point_extent.h"
#include "locate/circle_search.h"
#include "locate/nested_tanks.h"
#include "locate/ring_shape.h"
#include "locate/stray_points.h"
#include "locate/wall_map.h"
#include "locate/wall_sector.h"
#include "locate/walls_behind.h"
#include "search/voxel_sample.h"

namespace tank_datum {
namespace {

constexpr double kShortOfRingwall = 0.075;  // half of the way to the face of the narrowest ringwall [m]

struct Sample {
  Points points;
  double voxel = 0;
  bool strays = false;  ///< there were many, and are no more
};

/// A tank needs no more than every n-th point to be found; n is odd, since rows of a scan often have even lengths.
std::uint64_t strideOf(const Scan& scan) {
  constexpr std::uint64_t kLookedAt = 2'000'000;
  return scan.size() / kLookedAt | 1U;
}

/// About every n-th point of the scan, without those that no surface returned.
Points lookAt(const Scan& scan, int threads) {
  Points points = scan.everyNth(strideOf(scan), threads);
  dropNoReturns(points, -scan.origin());
  return points;
}

/// The edge of voxels as small as can be numbered on the way to the farthest point; every smallest radius has the same
/// ladder of voxels, and so the same tanks.
double finestVoxel(const Points& points) {
  constexpr double kRung = 0.008;                 // of this and of its halves and doubles are the edges [m]
  constexpr double kHalfRange = double(1 << 19);  // voxels
  double reach = 1e-9;
  for (const auto& p : points) reach = std::max(reach, p.cwiseAbs().maxCoeff());
  return kRung * std::exp2(std::ceil(std::log2(reach / kHalfRange / kRung)));
}

/// The scan thinned to a ladder of voxels, from where the densest surfaces just close (a tenth of the voxels hold two
/// points) to an eighth of the smallest diameter or, where a tank may be larger than it need be, to a small part of the
/// scan, and at least three rungs. Which rung shows a tank best depends on how much denser it was scanned than what
/// stands around it.
std::vector<Sample> samplesOf(const Points& looked_at, const LocateOptions& options, int threads) {
  constexpr double kSmallPart = 1.0 / 60.0;  // of the scan's reach: tanks fill a good part of their scan
  std::vector<Sample> samples;
  if (looked_at.empty()) return samples;
  const double coarsest = std::max(0.25 * options.min_radius, kSmallPart * extentOf(looked_at).reach);
  const double finest = finestVoxel(looked_at);
  VoxelSample sample(looked_at, options.sample_points, finest, threads);
  const bool strays = holdsStrays(sample);
  if (strays)
    sample = VoxelSample(withoutStrays(looked_at, closingEdge(sample)), options.sample_points, finest, threads);
  for (; sample.size() > 50; sample.coarsen()) {
    const double share = sample.shareHolding(2);
    // where most voxels hold several points, one that holds a single one is a stray beam
    if (share >= 0.1) samples.push_back({sample.points(share >= 0.5 ? 2 : 1), sample.voxel(), strays});
    if (samples.size() >= 3 && sample.voxel() > coarsest) break;
  }
  return samples;
}

/// Of all rows, the not finite ones too.
double shareNearFoot(const Scan& scan, const Points& looked_at, const Tank& tank) {
  const RingShape shape(tank, Tank::kNear);
  const auto near = std::count_if(looked_at.begin(), looked_at.end(), [&](const auto& p) { return shape.holds(p); });
  return static_cast<double>(near) * static_cast<double>(strideOf(scan)) / static_cast<double>(scan.size());
}

/// The foot against azimuth. Shells that end above a shadow outnumber, at times, those seen to their foot, but nothing
/// of a shell lies below it: the fit starts from the lowest fifth, and takes what agrees with it.
PeriodicFit fitFootHeights(const std::vector<double>& azimuths, const std::vector<double>& feet, double window) {
  constexpr double kQuiet = 0.02;  // with a short arc the slope is what little data say, not an extrapolation
  PeriodicFit fit;
  fit.coefficients = Eigen::Vector3d(quantile(feet, 0.2), 0, 0);
  for (int iteration = 0; iteration < 5; ++iteration) {
    std::vector<double> near_azimuths, near_feet;
    for (std::size_t i = 0; i < feet.size(); ++i) {
      if (std::abs(feet[i] - fit(azimuths[i])) > window) continue;
      near_azimuths.push_back(azimuths[i]);
      near_feet.push_back(feet[i]);
    }
    if (near_feet.empty()) break;
    fit = fitHarmonics(near_azimuths, near_feet, {}, {1, true, kQuiet});
  }
  return fit;
}

/// The circle through the shell's own points, over all of its height: the walls' cells know it to a share of a voxel
/// only. Tens of thousands of them, evenly spread, know it to a hundredth of a millimetre.
Circle refineCircle(const Sample& sample, const Circle& circle, const PeriodicFit& foot, double band) {
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : sample.points) {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    const double above = p.z() - foot(std::atan2(arm.y(), arm.x()));
    if (above > 2.0 * sample.voxel && std::abs(arm.norm() - circle.radius) <= band) plan.push_back(p.head<2>());
  }
  constexpr std::size_t kPlenty = 50'000;
  const std::size_t stride = plan.size() / kPlenty + 1;
  std::vector<Eigen::Vector2d> thinned;
  for (std::size_t i = 0; i < plan.size(); i += stride) thinned.push_back(plan[i]);
  const Circle fitted = fitCircleRobust(thinned, circle);
  return fitted.valid() ? fitted : circle;
}

/// Looks at the sample around a known circle: foot, side, coverage, height.
Tank describe(const Sample& sample, const Circle& circle, double rms) {
  Tank tank;
  tank.circle = circle;
  tank.rms = rms;
  tank.resolution = sample.voxel;
  tank.strays = sample.strays;
  auto sectors = sectorsOf(sample.points, sample.voxel, circle, std::max(1.5 * sample.voxel, 3.0 * rms));
  const double thickness = std::max(kShortOfRingwall, 3.0 * rms);
  std::vector<double> azimuths, feet, heights;
  std::vector<char> outside, inside;  // whether a foundation was seen on that side
  for (std::size_t s = 0; s < sectors.size(); ++s) {
    double bottom = 0, top = 0;
    if (!shellRun(sectors[s].shell, sample.voxel, thickness, bottom, top)) continue;
    azimuths.push_back((static_cast<double>(s) + 0.5) * kTwoPi / static_cast<double>(sectors.size()));
    feet.push_back(bottom);
    heights.push_back(top - bottom);
    outside.push_back(hasFoundation(sectors[s].outside, bottom, sample.voxel, circle.radius));
    inside.push_back(hasFoundation(sectors[s].inside, bottom, sample.voxel, circle.radius));
  }
  tank.coverage = kTwoPi * static_cast<double>(feet.size()) / static_cast<double>(sectors.size());
  tank.height = median(heights);
  const auto seen_outside = std::count(outside.begin(), outside.end(), 1);
  const auto seen_inside = std::count(inside.begin(), inside.end(), 1);
  tank.side = seen_inside > seen_outside ? Side::Inside : Side::Outside;
  const auto& foundation = tank.side == Side::Inside ? inside : outside;
  tank.has_foundation = 4 * std::max(seen_inside, seen_outside) >= static_cast<std::ptrdiff_t>(feet.size());
  for (std::size_t i = feet.size(); i-- > 0;) {  // a shell that ends above a shadow says nothing of the foot
    if (foundation[i] || !tank.has_foundation) continue;
    feet.erase(feet.begin() + static_cast<std::ptrdiff_t>(i));
    azimuths.erase(azimuths.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (!feet.empty()) tank.foot = fitFootHeights(azimuths, feet, 4.0 * sample.voxel + 0.02 * circle.radius);
  if (tank.foot.valid()) tank.circle = refineCircle(sample, circle, tank.foot, std::max(1.5 * sample.voxel, 3.0 * rms));
  return tank;
}

std::string degreesOf(double arc) { return std::to_string(std::lround(toDegrees(arc))) + " deg"; }

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

Found tanksOf(const Sample& sample, const LocateOptions& options) {
  const std::vector<WallCell> walls = mapWalls(sample.points, sample.voxel);
  Found all;
  for (const auto& found : findWallCircles(walls, sample.voxel, options)) {
    std::string reason = found.rejected;
    if (reason.empty()) {
      Tank tank = describe(sample, found.circle, found.rms);
      lookBehind(tank, walls);
      if (tank.coverage >= options.min_arc) {
        all.tanks.push_back(std::move(tank));
        continue;
      }
      reason = "its wall reaches down to a foot over " + degreesOf(tank.coverage) + " only";
    }
    all.rejected.push_back({found.circle, found.coverage, reason});
  }
  return all;
}

}  // namespace

double Tank::azimuthOf(const Eigen::Vector2d& p) const {
  const double azimuth = std::atan2(p.y() - circle.center.y(), p.x() - circle.center.x());
  return azimuth < 0 ? azimuth + kTwoPi : azimuth;
}

std::vector<Tank> locateTanks(const Scan& scan, const LocateOptions& options, int threads,
                              std::vector<RejectedCircle>* rejected) {
  const Points looked_at = lookAt(scan, threads);
  const std::vector<Sample> samples = samplesOf(looked_at, options, threads);
  std::vector<Found> found(samples.size());
  forEachIndex(samples.size(), threads, [&](std::size_t i) { found[i] = tanksOf(samples[i], options); });
  std::vector<Tank> tanks;
  for (Found& of_sample : found) {
    std::move(of_sample.tanks.begin(), of_sample.tanks.end(), std::back_inserter(tanks));
    if (rejected) std::move(of_sample.rejected.begin(), of_sample.rejected.end(), std::back_inserter(*rejected));
  }
  dropNested(tanks);
  const auto longer = [](const auto& a, const auto& b) {
    return a.coverage * a.circle.radius > b.coverage * b.circle.radius;
  };
  std::sort(tanks.begin(), tanks.end(), longer);
  if (rejected) std::stable_sort(rejected->begin(), rejected->end(), longer);
  for (Tank& tank : tanks) tank.near_foot = tank.foot.valid() ? shareNearFoot(scan, looked_at, tank) : 0.0;
  return tanks;
}

std::optional<Tank> describeTank(const Scan& scan, const Circle& circle, const LocateOptions& options, int threads) {
  const Points looked_at = lookAt(scan, threads);
  const std::vector<Sample> samples = samplesOf(looked_at, options, threads);
  if (samples.empty()) return std::nullopt;
  const Sample& sample = samples.front();
  Tank tank = describe(sample, circle, std::max(sample.voxel, 0.005 * circle.radius));
  if (!tank.foot.valid()) return std::nullopt;
  lookBehind(tank, mapWalls(sample.points, sample.voxel));
  tank.near_foot = shareNearFoot(scan, looked_at, tank);
  return tank;
}

}  // namespace tank_datum
