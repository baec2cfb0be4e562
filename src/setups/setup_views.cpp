#include "setups/setup_views.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "core/parts.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "locate/side_sign.h"
#include "setups/before_shell.h"
#include "stations/highest_wave.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

// Lengths are shares of the ring's reach, which is 0.5 m, or half of the radius of what is smaller than a metre.
constexpr double kClear = 0.04;      // of the shell: no weld, no blend [reach]
constexpr double kWidest = 0.7;      // the foundation is looked at so far out [reach]
constexpr double kFootBin = 0.04;    // of distance [reach]
constexpr double kShellFrom = 0.15;  // above the foot the shell is looked at from here [reach]
constexpr double kShellBin = 0.1;    // of height [reach]
constexpr double kDeepest = 0.4;     // the foundation lies no further from the coarse foot [reach]
constexpr double kBank = 0.15;       // fall of a surface that looks another from each place [m/m]

struct ArcPoints {
  std::vector<ArcPoint> foot, shell;
  double foot_radius = 0.0, foot_z = 0.0, shell_z = 0.0;  ///< means [m]
};

bool seesSeveral(const SetupRing::Entry* begin, const SetupRing::Entry* end) {
  return std::any_of(begin, end, [&](const SetupRing::Entry& e) { return e.setup != begin->setup; });
}

/// How the ring is cut into arcs.
struct ArcWidth {
  static constexpr std::size_t kNarrowest = SetupRing::kCells / SetupRing::kArcs;
  std::size_t cells = kNarrowest;  ///< of the ring in one arc

  std::size_t parts() const { return cells / kNarrowest; }  ///< as wide as the narrowest arc
  /// The part of an arc in which an azimuth lies.
  std::uint16_t partOf(double azimuth, std::size_t arc) const {
    const double along = azimuth / kTwoPi * static_cast<double>(SetupRing::kArcs) - static_cast<double>(arc * parts());
    return static_cast<std::uint16_t>(std::clamp(along, 0.0, static_cast<double>(parts() - 1)));
  }
  std::size_t count() const { return SetupRing::kCells / cells; }
  double middleOf(std::size_t arc) const { return middleOfCell(arc, count()); }
  double middleOf(std::size_t arc, std::uint16_t part) const {
    return middleOfCell(arc * parts() + part, SetupRing::kArcs);
  }
};

/// What is looked at.
struct Look {
  const SetupRing& ring;
  const Tank& tank;
  double reach;
  const ViewScope& scope;

  double heightOf(const SetupRing::Entry& e) const { return e.z - tank.foot(e.azimuth); }
  bool isShell(double off, double height) const {
    return std::abs(off) < scope.window * reach && height >= kShellFrom * reach;
  }

  /// A point without what its setup is thought to be off by.
  SetupRing::Entry unshifted(SetupRing::Entry e) const {
    if (scope.shifts.empty()) return e;
    const SetupMotion& shift = scope.shifts[e.setup];
    e.z -= shift.dz;
    e.radius -= portable::cos(e.azimuth) * shift.dx + portable::sin(e.azimuth) * shift.dy;
    return e;
  }
};

/// @param before  nothing for the foundation alone
ArcPoints pointsOf(const Look& look, const BeforeShell* before, ArcWidth width, std::size_t arc) {
  const auto& [ring, tank, reach, scope] = look;
  const SetupRing::Entry* begin = ring.begin(arc * width.cells);
  const SetupRing::Entry* end = ring.end((arc + 1) * width.cells - 1);
  ArcPoints all;
  if (begin == end || !seesSeveral(begin, end)) return all;
  const double middle = width.middleOf(arc), foot = tank.foot(middle);
  const double side = signOf(tank.side);
  const std::size_t every = static_cast<std::size_t>(end - begin) / scope.most_of_arc + 1;
  for (const SetupRing::Entry* at = begin; at < end;
       at += std::min<std::ptrdiff_t>(end - at, static_cast<std::ptrdiff_t>(every))) {
    const double outline = ring.outlineAt(at->azimuth);
    if (!std::isfinite(outline)) continue;
    const SetupRing::Entry e = look.unshifted(*at);
    const std::uint16_t part = width.partOf(e.azimuth, arc);
    const double t = (e.azimuth - width.middleOf(arc, part)) * outline, d = side * (e.radius - outline), h = e.z - foot;
    if (d >= kClear * reach && d < kWidest * reach && std::abs(h) < kDeepest * reach) {
      all.foot.push_back({t, e.z, static_cast<std::uint16_t>(d / (kFootBin * reach)), e.setup, part});
      all.foot_radius += e.radius;
      all.foot_z += e.z;
    } else if (before && look.isShell(d, h) && !before->holds(e)) {
      all.shell.push_back({t, e.radius - outline, static_cast<std::uint16_t>(h / (kShellBin * reach)), e.setup, part});
      all.shell_z += e.z;
    }
  }
  all.foot_radius /= std::max<double>(1.0, static_cast<double>(all.foot.size()));
  all.foot_z /= std::max<double>(1.0, static_cast<double>(all.foot.size()));
  all.shell_z /= std::max<double>(1.0, static_cast<double>(all.shell.size()));
  return all;
}

/// The narrowest arcs in which setups have points enough of the foundation to fill its bins.
ArcWidth widthOf(const Look& look, int threads) {
  constexpr std::size_t kLongest = 8 * ArcWidth::kNarrowest;
  constexpr double kPlenty = 100.0;  // points of a setup in an arc
  std::vector<std::vector<double>> counts(SetupRing::kArcs);
  forEachIndex(SetupRing::kArcs, threads, [&](std::size_t arc) {
    std::map<std::uint16_t, double> of_setups;
    for (const ArcPoint& p : pointsOf(look, nullptr, {}, arc).foot) of_setups[p.setup] += 1.0;
    for (const auto& [setup, points] : of_setups) counts[arc].push_back(points);
  });
  std::vector<double> all = concatenated(counts);
  ArcWidth width;
  if (all.empty()) return width;
  const double usual = median(std::move(all));
  while (width.cells < kLongest && usual * static_cast<double>(width.parts()) < kPlenty) width.cells *= 2;
  return width;
}

/// How steeply the points of a foundation fall away from the shell: the median slope between their bins, those near
/// each other alone, since one step down at a ringwall's edge is no bank [m/m].
double fallOf(const std::vector<ArcPoint>& foot, double bin_width) {
  constexpr double kNear = 5.5;  // bins
  std::vector<std::vector<double>> heights;
  for (const ArcPoint& p : foot) {
    if (p.bin >= heights.size()) heights.resize(p.bin + std::size_t{1});
    heights[p.bin].push_back(p.value);
  }
  std::vector<std::pair<double, double>> bins;  // distance, height
  for (std::size_t bin = 0; bin < heights.size(); ++bin) {
    if (!heights[bin].empty()) bins.emplace_back(bin_width * static_cast<double>(bin), median(std::move(heights[bin])));
  }
  std::vector<double> slopes;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    for (std::size_t j = i + 1; j < bins.size() && bins[j].first - bins[i].first < kNear * bin_width; ++j)
      slopes.push_back((bins[i].second - bins[j].second) / (bins[j].first - bins[i].first));
  }
  return slopes.empty() ? 0.0 : median(std::move(slopes));
}

/// Leaves the points of those parts of an arc in which setups meet. Their middle, or the arc's if there are none.
double keepWhereSetupsMeet(std::vector<ArcPoint>& points, ArcWidth width, std::size_t arc) {
  std::vector<std::optional<std::uint16_t>> first(width.parts());
  std::vector<char> meet(width.parts(), 0);
  for (const ArcPoint& p : points) {
    if (!first[p.part]) first[p.part] = p.setup;
    meet[p.part] |= static_cast<char>(p.setup != *first[p.part]);
  }
  points.erase(std::remove_if(points.begin(), points.end(), [&](const ArcPoint& p) { return !meet[p.part]; }),
               points.end());
  double sum = 0.0, count = 0.0;
  for (std::size_t part = 0; part < meet.size(); ++part) {
    if (!meet[part]) continue;
    sum += width.middleOf(arc, static_cast<std::uint16_t>(part));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : width.middleOf(arc);
}

/// What a setup's error does to an elevation at a place.
SetupMotion::Vector motionOfFoot(const Eigen::Vector3d& arm) {
  return (SetupMotion::Vector() << 1.0, arm.x(), arm.y(), 0.0, 0.0).finished();
}

/// And to a radius, in the direction outwards.
SetupMotion::Vector motionOfShell(const Eigen::Vector3d& arm, double azimuth) {
  const double c = portable::cos(azimuth), s = portable::sin(azimuth);
  return (SetupMotion::Vector() << 0.0, -c * arm.z(), -s * arm.z(), c, s).finished();
}

/// Makes offsets those of the points as they were given.
void addShifts(const std::vector<SetupMotion>& shifts, ArcView& view) {
  if (shifts.empty()) return;
  for (Eigen::Index i = 0; i < view.motion.rows(); ++i)
    view.seen.offsets[i] += view.motion.row(i).dot(shifts[view.seen.setups[static_cast<std::size_t>(i)]].vector());
  view.seen.offsets.array() -= view.seen.offsets.mean();
}

}  // namespace

std::vector<ArcView> viewArcs(const SetupRing& ring, const Tank& tank, double reach,
                              const std::vector<Eigen::Vector3d>& origins, const ViewScope& scope, int threads) {
  constexpr double kSettlement = 0.01;  // slope of a datum along its shell [m/m]
  constexpr double kLobe = 0.02;        // slope that the shell's outline leaves over [m/m]
  const Look look{ring, tank, reach, scope};
  const auto radius_of = [&look](const SetupRing::Entry& given) {
    const SetupRing::Entry e = look.unshifted(given);
    const double outline = look.ring.outlineAt(e.azimuth);
    return look.isShell(e.radius - outline, look.heightOf(e)) ? e.radius : kUnknown;
  };
  const BeforeShell before(ring, tank, reach, radius_of, threads);
  const ArcWidth width = widthOf(look, threads);
  const double length = tank.circle.radius * kTwoPi / static_cast<double>(width.count());
  const ArcPrior foot_prior{kSettlement, kHighestWave / tank.circle.radius, scope.window * reach, width.parts(),
                            kSettlement * length};
  const ArcPrior shell_prior{kLobe, 10.0 * kHighestWave / tank.circle.radius, scope.window * reach, width.parts(),
                             kLobe * length};
  std::vector<std::optional<ArcView>> found(2 * width.count());
  forEachIndex(width.count(), threads, [&](std::size_t arc) {
    ArcPoints points = pointsOf(look, &before, width, arc);
    for (const bool shell : {false, true}) {
      if (!shell && fallOf(points.foot, kFootBin * reach) > kBank) continue;
      std::vector<ArcPoint>& own = shell ? points.shell : points.foot;
      const double azimuth = keepWhereSetupsMeet(own, width, arc);
      const auto seen = compareArc(own, shell ? shell_prior : foot_prior);
      if (!seen) continue;
      const Eigen::Vector2d out(portable::cos(azimuth), portable::sin(azimuth));
      const double radius = shell ? tank.circle.radius : points.foot_radius;
      Eigen::Vector3d place;
      place << tank.circle.center + radius * out, (shell ? points.shell_z : points.foot_z);
      ArcView view;
      view.number = arc;
      view.shell = shell;
      view.azimuth = azimuth;
      view.seen = *seen;
      view.motion.resize(static_cast<Eigen::Index>(seen->setups.size()), SetupMotion::kParameters);
      for (std::size_t i = 0; i < seen->setups.size(); ++i) {
        const Eigen::Vector3d arm = place - origins[seen->setups[i]];
        view.motion.row(static_cast<Eigen::Index>(i)) = shell ? motionOfShell(arm, azimuth) : motionOfFoot(arm);
      }
      addShifts(scope.shifts, view);
      found[2 * arc + (shell ? 1 : 0)] = std::move(view);
    }
  });
  std::vector<ArcView> views;
  for (auto& view : found) {
    if (view) views.push_back(std::move(*view));
  }
  return views;
}

}  // namespace tank_datum
