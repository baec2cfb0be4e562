#include "setups/double_surface.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "core/parts.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/two_levels.h"
#include "setups/station_cells.h"

namespace tank_datum {
namespace {

constexpr std::size_t kArcs = 72;  // shorter than an overlap of two scans, with points enough to tell two levels

/// A point of the foundation: arc from the middle of its arc, distance from the shell, height over the stations' datum
/// and the foundation's slope [m].
struct BandPoint {
  double t, d, h;
};
using BandPoints = std::vector<BandPoint>;

using ArcPoints = std::vector<BandPoints>;  ///< of each arc

/// Where the ring's points are looked for.
struct Surface {
  StationCells cells;
  Eigen::Vector2d center;
  FoundationBand band;
  Side side;
  double tolerance;  ///< of the band at this reach [m]

  void add(const Eigen::Vector3d& point, ArcPoints& arcs) const;
};

void Surface::add(const Eigen::Vector3d& point, ArcPoints& arcs) const {
  const FootPlace foot = cells.placeOf(point, center, side);
  const double h = foot.h - band.slope * foot.d, turn = foot.azimuth / kTwoPi;
  if (!(foot.d >= band.from && foot.d <= band.to && std::abs(h) < tolerance)) return;
  const double place = (turn - std::floor(turn)) * kArcs;
  const auto arc = std::min(kArcs - 1, static_cast<std::size_t>(place));
  const double from_middle = place - static_cast<double>(arc) - 0.5;
  arcs[arc].push_back({from_middle * kTwoPi / kArcs * cells.level(foot.cell).radius, foot.d, h});
}

/// The foundation's points in each arc, in the order of the ring.
ArcPoints pointsOfArcs(const Points& points, const Surface& surface) {
  const auto parts = ofParts(points.size(), 0, [&](std::size_t begin, std::size_t end) {
    ArcPoints arcs(kArcs);
    for (std::size_t i = begin; i < end; ++i) surface.add(points[i], arcs);
    return arcs;
  });
  ArcPoints arcs(kArcs);
  for (const ArcPoints& part : parts) {
    for (std::size_t arc = 0; arc < kArcs; ++arc) arcs[arc].insert(arcs[arc].end(), part[arc].begin(), part[arc].end());
  }
  return arcs;
}

/// An even share of the points, not many more than are needed.
BandPoints thinned(const BandPoints& points) {
  constexpr std::size_t kPlenty = 1000;
  BandPoints kept;
  for (std::size_t i = 0; i < points.size(); i += points.size() / kPlenty + 1) kept.push_back(points[i]);
  return kept;
}

/// The points without the plane that most of them lie on.
BandPoints withoutPlane(BandPoints points) {
  constexpr double kFar = 4.0;  // standard deviations; points further off do not turn the plane
  constexpr int kPasses = 3;
  double most = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < kPasses; ++pass) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const BandPoint& p : points) {
      if (std::abs(p.h) > most) continue;
      const Eigen::Vector3d row(1.0, p.t, p.d);
      normal += row * row.transpose();
      right += row * p.h;
    }
    const Eigen::Vector3d plane = normal.ldlt().solve(right);
    std::vector<double> left;
    for (BandPoint& p : points) left.push_back(p.h -= plane.dot(Eigen::Vector3d(1.0, p.t, p.d)));
    most = kFar * robustSigma(left, median(left));
  }
  return points;
}

/// How much oftener than by chance a point and its nearest neighbour lie on the same level: 1 where the levels lie side
/// by side, 0 and less where two scans sample one place. Cohen's kappa.
double agreementOfNeighbours(const BandPoints& points, const TwoLevels& levels) {
  double agree = 0.0, high = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t nearest = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double t = points[j].t - points[i].t, d = points[j].d - points[i].d, square = t * t + d * d;
      if (square < least && j != i) least = square, nearest = j;
    }
    const bool is_high = levels.isHigh(points[i].h);
    high += is_high ? 1.0 : 0.0;
    agree += is_high == levels.isHigh(points[nearest].h) ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(points.size());
  const double share = high / count, chance = share * share + (1.0 - share) * (1.0 - share);
  return chance < 1.0 ? (agree / count - chance) / (1.0 - chance) : 1.0;
}

/// What two levels say of an arc's points.
struct ArcLevels {
  double apart = 0.0;  ///< distance of the two [m]; 0 where one will do, or where they lie side by side
  double gain = 0.0;   ///< of the logarithm of the likelihood against one level

  bool isDouble() const { return apart > 0.0; }
};

ArcLevels levelsOf(const BandPoints& points) {
  constexpr std::size_t kFewestPoints = 20;
  constexpr double kApart = 3.0;    // standard deviations; roughness of one surface is no dip between two
  constexpr double kShare = 0.1;    // of the points at least on either level
  constexpr double kBeside = 0.75;  // agreement of neighbours: roughness and steps of one surface; rows of a scan less
  if (points.size() < kFewestPoints) return {};
  const BandPoints flat = withoutPlane(points);
  std::vector<double> heights;
  for (const BandPoint& p : flat) heights.push_back(p.h);
  if (!(robustSigma(heights, 0.0) > 0.0)) return {};
  const TwoLevels levels = fitTwoLevels(heights);
  if (!(levels.gain > 0.0) || levels.apart() < kApart * levels.sigma) return {};
  if (std::min(levels.share, 1.0 - levels.share) < kShare || gainOfStrays(heights) >= levels.gain) return {};
  if (agreementOfNeighbours(flat, levels) > kBeside) return {};
  return {levels.apart(), levels.gain};
}

/// Whether two arcs side by side are double. Two scans overlap over more than an arc; one alone is chance.
bool areDouble(const ArcLevels& a, const ArcLevels& b) {
  constexpr double kGain = 16.0;  // of both; a rough surface gains up to 5 an arc
  return a.isDouble() && b.isDouble() && a.gain + b.gain > kGain;
}

}  // namespace

double doubleDisagreement(const Ring& ring, const Tank& tank, const std::vector<Station>& stations,
                          const Eigen::Vector2d& center, const FoundationBand& band) {
  const Surface surface{StationCells(stations), center, band, tank.side, band.tolerance(ring.reach)};
  const ArcPoints arcs = pointsOfArcs(ring.points, surface);
  std::vector<ArcLevels> levels(kArcs);
  forEachIndex(kArcs, 0, [&](std::size_t arc) { levels[arc] = levelsOf(thinned(arcs[arc])); });
  double squares = 0.0, doubled = 0.0;
  for (std::size_t arc = 0; arc < kArcs; ++arc) {
    const ArcLevels &here = levels[arc], &before = levels[(arc + kArcs - 1) % kArcs],
                    &after = levels[(arc + 1) % kArcs];
    if (!areDouble(here, before) && !areDouble(here, after)) continue;
    squares += here.apart * here.apart;
    doubled += 1.0;
  }
  return doubled > 0.0 ? std::sqrt(0.5 * squares / doubled) : 0.0;
}

}  // namespace tank_datum
