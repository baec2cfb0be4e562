#include "foot/shell_bends.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// A point of the shell: its height above the foot, and how far it is off the line of its station [m].
struct OffLine {
  double height, off;
};

/// How the shell runs off its line over a part of its height: off = offset + slope h.
struct Bend {
  double offset = 0.0, slope = 0.0;
  double sigma = kUnknown;  ///< of the offset, which is at the foot [m]
  double noise = kUnknown;  ///< [m]
  double to = 0.0;          ///< height that it is fitted up to [m]

  bool valid() const { return sigma > 0.0; }
  double at(double height) const { return offset + slope * height; }
};

/// A robust line through points; not valid for few.
Bend fitBend(const std::vector<OffLine>& points) {
  constexpr std::size_t kFewest = 12;
  Bend bend;
  if (points.size() < kFewest) return bend;
  std::vector<double> weights(points.size(), 1.0), left(points.size());
  double noise = 0, inverse = 0;
  for (int iteration = 0; iteration < 8; ++iteration) {
    double n = 0, h = 0, hh = 0, off = 0, product = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double w = weights[i], height = points[i].height;
      n += w, h += w * height, hh += w * height * height;
      off += w * points[i].off, product += w * height * points[i].off;
    }
    const double determinant = n * hh - h * h;
    if (!(determinant > 0.0)) return bend;
    bend.offset = (hh * off - h * product) / determinant;
    bend.slope = (n * product - h * off) / determinant;
    inverse = hh / determinant;
    for (std::size_t i = 0; i < points.size(); ++i) left[i] = points[i].off - bend.at(points[i].height);
    noise = std::max(robustSigma(left, 0.0), 1e-7);
    for (std::size_t i = 0; i < points.size(); ++i) weights[i] = tukeyWeight(left[i] / noise);
  }
  bend.noise = noise;
  bend.sigma = noise * std::sqrt(inverse);
  return bend;
}

/// The points of the shell about a station, and as far beside it again as tells bends from noise.
std::vector<OffLine> pointsAbout(std::size_t station, const PolarRing& ring, const std::vector<ShellLine>& lines,
                                 const ShellWindow& window) {
  constexpr double kWider = 2.5;        // than the window of the line
  constexpr double kBeside = 0.2;       // of the window's height: a shell bends by less
  constexpr std::size_t kPlenty = 600;  // points, of those in a window so much wider
  const auto count = static_cast<std::ptrdiff_t>(lines.size());
  const double step = kTwoPi / static_cast<double>(count);
  const auto seen = static_cast<std::size_t>(kWider * static_cast<double>(lines[station].points));
  const std::size_t stride = seen / kPlenty | 1U;
  std::size_t passed = 0;
  std::vector<OffLine> points;
  ring.around(window.azimuth, kWider * window.half_width, [&](const PolarPoint& p, double turn) {
    if (passed++ % stride != 0) return;
    const double height = p.z - window.foot;
    if (height < 0.0 || height > window.heights.to) return;
    const std::ptrdiff_t away = std::lround(turn / step);
    const auto nearest = (static_cast<std::ptrdiff_t>(station) + away + count) % count;
    const ShellLine& line = lines[static_cast<std::size_t>(nearest)];
    if (!line.seen()) return;
    const double t = (turn - static_cast<double>(away) * step) * line.radius;
    const double off = p.radius - line.at(t, height);
    if (std::abs(off) < kBeside * window.heights.to) points.push_back({height, off});
  });
  return points;
}

/// The bends of nested parts of the shell from its foot on, the largest first, which is none; each among the points
/// that lie about the one before.
std::vector<Bend> nestedBends(const std::vector<OffLine>& points, const ShellLine& line, const ShellWindow& window) {
  constexpr double kPart = 0.6, kLowest = 0.05;  // of the window's height; a weld and errors of the foot are below
  constexpr int kParts = 3;
  constexpr double kApart = 6.0;     // noises: what is farther off is another thing
  constexpr double kSteepest = 0.1;  // of a shell off its line [m/m]: a sheet that slopes out of it is steeper
  std::vector<Bend> bends{{0.0, 0.0, line.sigma_radius, line.noise, window.heights.to}};
  double to = window.heights.to;
  for (int i = 0; i < kParts; ++i) {
    const Bend& wider = bends.back();
    to *= kPart;
    std::vector<OffLine> part;
    for (const OffLine& p : points) {
      if (p.height >= kLowest * window.heights.to && p.height <= to &&
          std::abs(p.off - wider.at(p.height)) < kApart * wider.noise)
        part.push_back(p);
    }
    Bend bend = fitBend(part);
    if (!bend.valid() || std::abs(bend.slope) > kSteepest) break;
    bend.to = to;
    bends.push_back(bend);
  }
  return bends;
}

/// The first bend, which is of the largest part, that agrees with all others.
const Bend& largestThatAgrees(const std::vector<Bend>& bends) {
  constexpr double kAgree = 4.0;  // standard errors
  const auto agrees = [&](const Bend& bend) {
    return std::all_of(bends.begin(), bends.end(), [&](const Bend& other) {
      return other.to >= bend.to ||
             std::abs(other.offset - bend.offset) <= kAgree * std::hypot(other.sigma, bend.sigma);
    });
  };
  return *std::find_if(bends.begin(), bends.end(), agrees);
}

}  // namespace

std::vector<ShellLine> linesAtFoot(const PolarRing& ring, const std::vector<ShellLine>& lines,
                                   const std::vector<ShellWindow>& windows) {
  std::vector<ShellLine> at_foot = lines;
  std::vector<double> noises(lines.size(), kUnknown);
  forEachIndex(lines.size(), 0, [&](std::size_t i) {
    if (!lines[i].seen()) return;
    const std::vector<Bend> bends = nestedBends(pointsAbout(i, ring, lines, windows[i]), lines[i], windows[i]);
    if (bends.size() > 1) noises[i] = bends.back().noise;
    const Bend& chosen = largestThatAgrees(bends);
    at_foot[i].radius += chosen.offset;
    at_foot[i].lean += chosen.slope;
    if (&chosen != &bends.front()) at_foot[i].sigma_radius = std::hypot(chosen.sigma, lines[i].sigma_along);
    at_foot[i].noise = chosen.noise;
    at_foot[i].straight_to = chosen.to;
  });
  const bool resolved = !windows.empty() && median(finiteOf(noises)) <= kResolved * windows.front().heights.to;
  return resolved ? at_foot : lines;
}

}  // namespace tank_datum
