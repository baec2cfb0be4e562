#include "movement/same_tank.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/plain_text.h"
#include "core/units.h"
#include "tank_datum/core/error.h"
#include "tank_datum/datum.h"

namespace tank_datum {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& value, const std::string& expected) {
  throw Error(Error::Kind::Option, "movement", what, value, expected);
}

/// What one survey's lengths must be multiplied by, if a wrong unit explains the ratio; or nothing.
std::string unitBehind(double ratio) {
  if (ratio < 1.0) ratio = 1.0 / ratio;
  for (const auto& [factor, name] :
       {std::pair{1000.0, "mm and m"}, {1000.0 * kMetresPerFoot, "mm and ft"}, {1.0 / kMetresPerFoot, "ft and m"}}) {
    if (std::abs(ratio / factor - 1.0) < 0.01) return std::string(" (as ") + name + " taken for each other)";
  }
  return {};
}

void requireSameKind(const Epoch& baseline, const Epoch& current) {
  for (const Epoch* epoch : {&baseline, &current}) {
    if (epoch->method == nameOf(Method::Paper)) {
      refuse("method of " + epoch->name, epoch->method, "refined: the paper's elevations have no standard errors");
    }
  }
  if (baseline.method != current.method) {
    refuse("method of " + current.name, current.method, "the baseline's, " + baseline.method);
  }
}

}  // namespace

bool shareFrame(const Epoch& baseline, const MovementOptions& options) {
  return !baseline.levelled && !options.estimate_offset && options.azimuth_offset == 0.0;
}

Removal removalOf(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  if (options.removal != Removal::Auto) return options.removal;
  return baseline.levelled != current.levelled ? Removal::Mean : Removal::Nothing;
}

Removal removalOf(const std::vector<Epoch>& surveys, const MovementOptions& options) {
  const auto other = std::find_if(surveys.begin(), surveys.end(), [&](const Epoch& survey) {
    return removalOf(surveys.front(), survey, options) != Removal::Nothing;
  });
  return other == surveys.end() ? Removal::Nothing : removalOf(surveys.front(), *other, options);
}

void requireSameTank(const Epoch& baseline, const std::string& name, const Circle& circle,
                     const MovementOptions& options) {
  const double from = baseline.circle.radius, to = circle.radius;
  if (!(std::abs(to - from) <= options.radius_difference)) {
    refuse("radius of " + name, generalText(to) + " m",
           "within " + generalText(options.radius_difference) + " m of the baseline's " + generalText(from) +
               unitBehind(to / from));
  }
  const double apart = (circle.center - baseline.circle.center).norm();
  if (shareFrame(baseline, options) && !(apart <= options.centre_distance)) {
    refuse("centre of " + name, generalText(apart) + " m from the baseline's",
           "within " + generalText(options.centre_distance) + " m, the same tank in the same frame");
  }
}

void requireErrors(const Epoch& epoch) {
  if (epoch.judgeable() > 0) return;
  refuse("standard errors of " + epoch.name, "none",
         epoch.levelled ? "a sigma column in the levelling's table: the standard error of each elevation"
                        : "sigma_z of its measured stations");
}

void requireComparable(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  const Eigen::Vector2d center = current.levelled ? baseline.circle.center : current.circle.center;
  requireSameTank(baseline, current.name, {center, current.circle.radius}, options);
  requireSameKind(baseline, current);
  requireErrors(baseline);
  requireErrors(current);
}

void requireSameSurface(const Epoch& baseline, const Epoch& current, const Movement& movement) {
  constexpr double kThinnest = 0.006;  // annular plates [m]
  constexpr double kKnown = 0.5;       // of the half: a standard error
  if (baseline.levelled || current.levelled || baseline.surface == current.surface) return;
  const auto is_plate = [](const Epoch& e) { return e.surface == nameOf(Surface::AnnularPlate); };
  const auto lies_below = [](const Epoch& e) {
    return e.surface == nameOf(Surface::Foundation) || e.surface == nameOf(Surface::Ringwall);
  };
  if (lies_below(baseline) && lies_below(current)) return;
  const bool are_known = (is_plate(baseline) && lies_below(current)) || (lies_below(baseline) && is_plate(current));
  const double half = 0.5 * kThinnest;
  if (are_known && std::abs(movement.mean) < half && movement.sigma_mean < kKnown * half) return;
  refuse("foundation surface of " + current.name, current.surface, "the baseline's, " + baseline.surface);
}

}  // namespace tank_datum
