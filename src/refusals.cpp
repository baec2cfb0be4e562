#include "refusals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

#include "core/units.h"
#include "io/up_axis.h"
#include "locate/locate.h"

namespace tank_datum {

std::string candidateText(const Circle& circle, double coverage, const Eigen::Vector3d& origin) {
  char text[160];
  std::snprintf(text, sizeof text, "circle found, R %.4g m at %.10g, %.10g, seen over %.0f deg", circle.radius,
                std::round(1e3 * (circle.center.x() + origin.x())) / 1e3,
                std::round(1e3 * (circle.center.y() + origin.y())) / 1e3, toDegrees(coverage));
  return text;
}

std::string whyNoTank(const Scan& scan, const DatumOptions& options) {
  std::ostringstream message;
  if (options.tank) {
    message << "the scan shows no shell on the given circle, of radius " << options.tank->radius << " m";
    return message.str();
  }
  message << "no vertical cylinder with a radius of " << options.locate.min_radius << " m or more stands in the scan";
  std::vector<RejectedCircle> rejected;
  locateTanks(scan, options.locate, options.threads, &rejected);
  if (!rejected.empty()) {
    const RejectedCircle& best = rejected.front();
    message << "; " << candidateText(best.circle, best.coverage, scan.origin()) << ", rejected: " << best.reason;
  }
  message << otherAxis(scan, options);
  return message.str();
}

std::string otherAxis(const Scan& scan, const DatumOptions& options) {
  if (options.tank) return {};
  for (const std::string axis : {"y", "-z", "-y", "x", "-x"}) {
    const std::vector<Tank> tanks = locateTanks(scan.turned(upRotation(axis)), options.locate, options.threads);
    const auto stands = [](const Tank& tank) { return tank.has_foundation && tank.behind_share < 0.1; };
    const auto tank = std::find_if(tanks.begin(), tanks.end(), stands);
    if (tank == tanks.end()) continue;
    char text[120];
    std::snprintf(text, sizeof text, "; along %s stands a cylinder of R %.4g m: is that up (option up %s)?",
                  axis.c_str(), tank->circle.radius, axis.c_str());
    return text;
  }
  return {};
}

std::string doubtfulUnits(double radius) {
  constexpr double kLargest = 150.0;  // the largest tanks have 60 m, gas holders of old 35 m, reservoirs of water 100 m
  if (!(radius > kLargest)) return {};
  char text[64];
  std::snprintf(text, sizeof text, "R = %.0f m: is the scan in mm?", radius);
  return text;
}

std::string leanText(const Datum& datum, const StationOptions& options) {
  constexpr double kWorthSaying = 0.00175;  // a tenth of a degree [m/m]
  const ShellLean& lean = datum.lean;
  if (!lean.known() || lean.slope.norm() < std::max(kWorthSaying, 4.0 * lean.sigma)) return {};
  const double direction = std::atan2(lean.slope.y(), lean.slope.x()) - options.zero_azimuth;
  double degrees = toDegrees(options.clockwise ? -direction : direction);
  degrees -= 360.0 * std::floor(degrees / 360.0);
  const bool together = datum.tilt.valid() &&
                        (lean.slope + datum.tilt.gradient).norm() < std::max(0.2 * lean.slope.norm(), 4.0 * lean.sigma);
  char text[160];
  std::snprintf(text, sizeof text, "%s by %.2f deg towards %.0f deg%s",
                together ? "shell and foundation lean together" : "the shell leans",
                toDegrees(std::atan(lean.slope.norm())), degrees,
                together ? " (of the tank or of the scan: cannot be told)" : "");
  return text;
}

}  // namespace tank_datum
