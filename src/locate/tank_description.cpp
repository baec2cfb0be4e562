#include "locate/tank_description.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/portable_math.h"
#include "core/ring_runs.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/circle.h"
#include "fit/ring_cells.h"
#include "locate/filled_wall.h"
#include "locate/foot_heights.h"
#include "locate/foot_unit.h"
#include "locate/ring_shape.h"
#include "locate/step_back.h"
#include "locate/wall_sector.h"

namespace tank_datum {
namespace {

/// The circle through the shell's own points, over all of its height: the walls' cells know it to a share of a voxel
/// only. Tens of thousands of them, evenly spread, know it to a hundredth of a millimetre.
Circle refineCircle(const Points& points, double voxel, const Circle& circle, const PeriodicFit& foot, double band) {
  std::vector<Eigen::Vector2d> plan;
  for (const auto& p : points) {
    const Eigen::Vector2d arm = p.head<2>() - circle.center;
    if (std::abs(arm.norm() - circle.radius) > band) continue;
    if (p.z() - foot(portable::atan2(arm.y(), arm.x())) > 2.0 * voxel) plan.push_back(p.head<2>());
  }
  constexpr std::size_t kPlenty = 50'000;
  const std::size_t stride = plan.size() / kPlenty + 1;
  std::vector<Eigen::Vector2d> thinned;
  for (std::size_t i = 0; i < plan.size(); i += stride) thinned.push_back(plan[i]);
  const Circle fitted = fitCircleRobust(thinned, circle);
  return fitted.valid() ? fitted : circle;
}

/// What is seen of the wall in one sector.
struct WallView {
  double azimuth = 0;
  bool stands = false;                   ///< on the circle
  double bottom = 0, top = 0;            ///< [m]
  bool outside = false, inside = false;  ///< whether a foundation was seen on that side
  StepBack step;                         ///< of what stands there and around
  bool behind_top = false;               ///< whether something lies there, as a ringwall's top does
};

/// The shell in every sector. Where most of it goes on under holes, it is what something about it hides, a girder: all
/// of it begins under them.
std::vector<std::optional<WallRun>> shellRuns(const std::vector<Sector>& sectors, double voxel, double thickness) {
  std::vector<std::optional<WallRun>> runs;
  std::size_t stand = 0, go_on = 0;
  for (const Sector& sector : sectors) {
    runs.push_back(shellRun(sector.shell, voxel, thickness));
    if (runs.back()) ++stand, go_on += runs.back()->under < runs.back()->bottom;
  }
  if (2 * go_on <= stand) return runs;
  for (auto& run : runs) {
    if (run) run->bottom = run->under;
  }
  return runs;
}

std::vector<WallView> viewsOf(const Points& points, double voxel, const Circle& circle, double rms) {
  const auto sectors = sectorsOf(points, voxel, circle, bandOf(voxel, rms));
  const double thickness = thicknessOf(rms);
  const auto runs = shellRuns(sectors, voxel, thickness);
  std::vector<WallView> views(sectors.size());
  for (std::size_t i = 0; i < sectors.size(); ++i) {
    WallView& view = views[i];
    view.azimuth = middleOfCell(i, sectors.size());
    view.stands = runs[i].has_value();
    view.step = findStepBack(sectors[i].around, voxel, kShortOfRingwall);
    if (!view.stands) continue;
    view.bottom = runs[i]->bottom, view.top = runs[i]->top;
    const auto is_high = [&](double z) { return z > view.top - 2.0 * voxel; };
    const auto is_behind = [&](const Hit& hit) { return hit.off < -thickness && is_high(hit.z); };
    const std::vector<double>& farther = sectors[i].farther_in;  // upon a roof; the shell upon a ringwall hides it
    const auto goes_on = [&](const Hit& hit) { return hit.z > view.top + 2.0 * voxel; };  // a shell that few rays meet
    const auto behind = std::count_if(sectors[i].around.begin(), sectors[i].around.end(), is_behind),
               above = std::count_if(sectors[i].shell.begin(), sectors[i].shell.end(), goes_on);
    view.behind_top = behind > above && std::none_of(farther.begin(), farther.end(), is_high);
    view.outside = hasFoundation(sectors[i].outside, view.bottom, voxel, circle.radius);
    view.inside = hasFoundation(sectors[i].inside, view.bottom, voxel, circle.radius);
  }
  return views;
}

std::vector<StepBack> stepsOf(const std::vector<WallView>& views) {
  std::vector<StepBack> steps;
  for (const WallView& view : views) steps.push_back(view.step);
  return steps;
}

double faceHeight(const std::vector<StepBack>& steps) {
  return medianOf(steps, [](const StepBack& step) { return step.faceHeight(); });
}

/// Whether walls step back over most of the azimuths that tell: those at which a step is seen, or a wall that goes
/// straight past where the others have theirs.
bool standsOnRingwall(const std::vector<WallView>& views, double voxel) {
  const double past = faceHeight(stepsOf(views)) + kFewestVoxels * voxel;
  std::size_t steps = 0, straight = 0;
  for (const WallView& view : views) {
    if (view.step.found()) ++steps;
    if (!view.step.found() && view.stands && view.top - view.bottom >= past) ++straight;
  }
  return steps > straight;
}

/// Whether what stands on the circle begins where walls step back, most often.
bool beginAtSteps(const std::vector<WallView>& views, double voxel) {
  std::vector<double> apart;
  for (const WallView& view : views) {
    if (view.stands && view.step.found()) apart.push_back(std::abs(view.bottom - view.step.height));
  }
  return median(apart) <= kFewestVoxels * voxel;
}

/// The circle on which walls stand above their steps, and what they are off it [m].
Circle setBackCircle(const std::vector<WallView>& views, const Circle& circle, double& rms) {
  std::vector<Eigen::Vector2d> plan;
  for (const WallView& view : views) {
    const Eigen::Vector2d direction(portable::cos(view.azimuth), portable::sin(view.azimuth));
    if (view.step.found()) plan.push_back(circle.center + (circle.radius + view.step.off) * direction);
  }
  const Circle fitted = fitCircleRobust(plan, circle);
  if (!fitted.valid()) return circle;
  std::vector<double> residuals;
  for (const auto& p : plan) residuals.push_back(fitted.residual(p));
  rms = robustSigma(residuals, 0.0);
  return fitted;
}

/// The walls above their steps.
std::vector<WallView> aboveSteps(std::vector<WallView> views) {
  for (WallView& view : views) {
    view.stands = view.outside = view.step.found();
    view.inside = false;
    view.bottom = view.step.height, view.top = view.step.top;
  }
  return views;
}

/// The longest arc in which a foundation is seen beside the shell; of a few sectors, none [rad].
double longestFoundation(const std::vector<WallView>& views, Side side) {
  constexpr std::size_t kFewest = 4;  // sectors, in which something lies by chance
  std::vector<char> seen;
  for (const WallView& view : views)
    seen.push_back(view.stands && (side == Side::Inside ? view.inside : view.outside) ? 1 : 0);
  std::size_t longest = 0;
  for (const RingRun& run : runsRound(seen)) longest = std::max(longest, run.last - run.first + 1);
  return longest < kFewest ? 0.0 : kTwoPi * static_cast<double>(longest) / static_cast<double>(views.size());
}

/// What the views say of a tank, its foot and circle apart.
void look(Tank& tank, const std::vector<WallView>& views, double least) {
  std::vector<double> heights;
  std::size_t outside = 0, inside = 0;
  for (const WallView& view : views) {
    if (!view.stands) continue;
    heights.push_back(view.top - view.bottom);
    outside += view.outside, inside += view.inside;
  }
  const auto seen = static_cast<double>(heights.size());
  tank.coverage = kTwoPi * seen / static_cast<double>(views.size());
  tank.height = median(heights);
  tank.side = inside > outside ? Side::Inside : Side::Outside;
  const auto count = static_cast<double>(tank.side == Side::Inside ? inside : outside);
  tank.has_foundation =
      count >= least * seen || longestFoundation(views, tank.side) >= kFoundationArc * least / kLeastFoundation;
}

/// Of a wall no higher than a ringwall's face, see Tank::low_wall.
double shareBehindTop(const std::vector<WallView>& views) {
  std::size_t stand = 0, behind = 0;
  for (const WallView& view : views) stand += view.stands, behind += view.stands && view.behind_top;
  return static_cast<double>(behind) / static_cast<double>(stand);
}

/// See Tank::low_wall.
double lowWall(const Tank& tank, const std::vector<WallView>& views, const Points& points, double voxel) {
  if (tank.side == Side::Inside || !(tank.height <= kHighestRingwall)) return kUnknown;
  const double filled = shareFilled(points, voxel, tank);
  if (tank.standsOnRingwall()) return filled > 0.0 ? filled : kUnknown;
  return std::max(filled, shareBehindTop(views));
}

/// The feet of the walls; a shell that ends above a shadow says nothing of the foot.
PeriodicFit footOf(const Tank& tank, const std::vector<WallView>& views) {
  std::vector<double> feet;
  for (const WallView& view : views) {
    const bool foundation = tank.side == Side::Inside ? view.inside : view.outside;
    feet.push_back(view.stands && (!tank.has_foundation || foundation) ? view.bottom : kUnknown);
  }
  constexpr double kWithinReach = 0.6;  // of what is cropped above and below the foot
  const double unit = footUnit(tank.circle.radius, tank.resolution);
  const double reach = reachOf(tank, CropOptions().reach * unit);
  return fitFootHeights(feet, tank.resolution,
                        {4.0 * tank.resolution + 0.02 * tank.circle.radius, kWithinReach * reach});
}

}  // namespace

Tank describe(const Points& points, const Sample& sample, const Circle& circle, double rms, double least, bool given) {
  Tank tank;
  tank.circle = circle;
  tank.rms = rms;
  tank.resolution = sample.voxel;
  tank.strays = sample.strays;
  std::vector<WallView> views = viewsOf(points, sample.voxel, circle, rms);
  look(tank, views, least);
  if (tank.side == Side::Outside && standsOnRingwall(views, sample.voxel)) {
    const std::vector<StepBack> steps = stepsOf(views);
    tank.ringwall_width = medianOf(steps, [](const StepBack& step) { return step.width; });
    tank.ringwall_height = faceHeight(steps);
    double above = rms;
    const Circle shell = setBackCircle(views, circle, above);
    const double moved = (shell.center - circle.center).norm() + std::abs(shell.radius - circle.radius);
    const bool is_face = moved > kShortOfRingwall, is_both = 3.0 * rms > kShortOfRingwall;
    if (given ? !is_face : is_face || is_both || !tank.has_foundation) {
      tank.circle = shell, tank.rms = above;
      views = aboveSteps(std::move(views));
      look(tank, views, least);
    } else if (given || !beginAtSteps(views, sample.voxel)) {
      tank.ringwall_width = tank.ringwall_height = 0.0;
    }
  }
  tank.low_wall = lowWall(tank, views, points, sample.voxel);
  tank.foot = footOf(tank, views);
  if (tank.foot.valid())
    tank.circle = refineCircle(points, sample.voxel, tank.circle, tank.foot, bandOf(sample.voxel, tank.rms));
  return tank;
}

}  // namespace tank_datum
