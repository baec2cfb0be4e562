#include "refusals.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "io/up_axis.h"
#include "locate/locate.h"
#include "stations/stations.h"

namespace tank_datum {

std::string candidateText(const Circle& circle, double coverage, const Eigen::Vector3d& origin) {
  const auto rounded = [](double metres) { return std::round(1e3 * metres) / 1e3 + 0.0; };  // no "-0"
  const Eigen::Vector2d centre = circle.center + origin.head<2>();
  char text[160];
  snprintfPlain(text, sizeof text, "circle found, R %.4g m at %.10g, %.10g, seen over %.0f deg", circle.radius,
                rounded(centre.x()), rounded(centre.y()), toDegrees(coverage));
  return text;
}

std::string whyNoTank(const Scan& scan, const DatumOptions& options, Circle& tried) {
  if (options.tank) {
    tried = {options.tank->center - scan.origin().head<2>(), options.tank->radius};
    return "the scan shows no shell on the given circle, of radius " + generalText(options.tank->radius) + " m";
  }
  std::string message = "no vertical cylinder with a radius of " + generalText(options.locate.min_radius) +
                        " m or more stands in the scan";
  std::vector<RejectedCircle> rejected;
  locateTanks(scan, options.locate, options.threads, &rejected);
  if (!rejected.empty()) {
    const RejectedCircle& best = rejected.front();
    tried = best.circle;
    message += "; " + candidateText(best.circle, best.coverage, scan.origin()) + ", rejected: " + best.reason;
  }
  return message + otherAxis(scan, options);
}

std::string otherAxis(const Scan& scan, const DatumOptions& options) {
  if (options.tank) return {};
  for (const std::string axis : {"y", "-z", "-y", "x", "-x"}) {
    const std::vector<Tank> tanks = locateTanks(scan.turned(upRotation(axis)), options.locate, options.threads);
    const auto stands = [](const Tank& tank) { return tank.has_foundation && tank.behind_share < 0.1; };
    const auto tank = std::find_if(tanks.begin(), tanks.end(), stands);
    if (tank == tanks.end()) continue;
    char text[120];
    snprintfPlain(text, sizeof text, "; along %s stands a cylinder of R %.4g m: is that up (option up %s)?",
                  axis.c_str(), tank->circle.radius, axis.c_str());
    return text;
  }
  return {};
}

std::string whyNoCurve(const Normals& normals, const std::vector<std::int32_t>& candidates, const EdgePoints& edge) {
  if (!candidates.empty()) return std::to_string(edge.indices.size()) + " edge points lie along the foot";
  constexpr float kSame = 1e-6F;  // 1 - cosine
  const auto same = [&](const Eigen::Vector3f& n) { return 1.0F - std::abs(n.dot(normals.normals[0])) < kSame; };
  const bool constant = std::all_of(normals.normals.begin(), normals.normals.end(), same);
  return constant ? "all normals are the same" : "no neighbouring normals differ by more than option angle_deg";
}

std::string doubtfulUnits(double radius) {
  constexpr double kLargest = 100.0;         // the largest tanks have 60 m, reservoirs of water 100 m
  constexpr double kLargestInFeet = 1000.0;  // that no tank in feet taken for metres has
  if (!(radius > kLargest)) return {};
  return formatted("R = %.0f m: is the scan in %s?", radius, radius > kLargestInFeet ? "mm" : "ft or mm");
}

std::string leanText(const Datum& datum, const StationOptions& options) {
  constexpr double kWorthSaying = 0.00175;  // a tenth of a degree [m/m]
  const ShellLean& lean = datum.lean;
  if (!lean.known() || lean.slope.norm() < std::max(kWorthSaying, 4.0 * lean.sigma)) return {};
  const double degrees = toDegrees(azimuthOf(portable::atan2(lean.slope.y(), lean.slope.x()), options));
  const bool together = datum.tilt.valid() &&
                        (lean.slope + datum.tilt.gradient).norm() < std::max(0.2 * lean.slope.norm(), 4.0 * lean.sigma);
  char text[160];
  snprintfPlain(text, sizeof text, "%s by %.2f deg towards %.0f deg%s",
                together ? "shell and foundation lean together" : "the shell leans",
                toDegrees(portable::atan(lean.slope.norm())), degrees,
                together ? " (of the tank or of the scan: cannot be told)" : "");
  return text;
}

std::string ringwallText(const Tank& tank) {
  if (!tank.standsOnRingwall()) return {};
  char text[120];
  snprintfPlain(text, sizeof text,
                "The shell begins %.1f m above the ground, upon a ringwall that stands out by %.2f m.",
                tank.ringwall_height, tank.ringwall_width);
  return text;
}

}  // namespace tank_datum
