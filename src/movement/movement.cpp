#include "movement/movement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/normal95.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/refusal.h"
#include "core/statistics.h"
#include "core/units.h"
#include "movement/epoch_matching.h"
#include "movement/movement_errors.h"
#include "movement/movement_significance.h"
#include "tank_datum/core/error.h"
#include "tank_datum/datum.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestStations = 8;  ///< stations in common

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
  if (!baseline.levelled && !current.levelled && baseline.surface != current.surface) {
    refuse("foundation surface of " + current.name, current.surface, "the baseline's, " + baseline.surface);
  }
}

/// The stations that a matching is of, without their movement.
std::vector<StationMovement> stationsOf(const Epoch& baseline, const Epoch& current, const Matching& matching,
                                        double offset) {
  std::vector<StationMovement> stations;
  for (const Elevation& e : (matching.of_baseline ? baseline : current).stations) {
    if (matching.of_baseline) {
      stations.push_back({azimuthIn(current, e.direction - offset), e.direction});
    } else {
      stations.push_back({e.azimuth, e.direction + offset});
    }
  }
  return stations;
}

/// Settlement and tilt of the whole, each with its test.
void describeWhole(const CommonMotion& motion, double freedom, double radius, Movement& movement) {
  movement.mean = motion.mean, movement.sigma_mean = motion.sigma_mean;
  movement.mean_significant = std::abs(motion.mean) > student95(freedom) * motion.sigma_mean;
  movement.tilt_change = motion.rim.norm() / radius;
  const Eigen::Vector2d along = motion.rim.normalized();
  movement.sigma_tilt_change = std::sqrt(along.dot(motion.covariance * along)) / radius;
  movement.tilt_direction = withinTurn(portable::atan2(motion.rim.y(), motion.rim.x()));
  movement.tilt_p_value = tiltPValue(motion, freedom);
  movement.tilt_significant = movement.tilt_p_value < 0.05;
}

/// What is left of the movement without that of the tank as a rigid body, and its largest.
void describeRest(std::vector<MatchedStation> matched, const CommonErrors& common, const MovementOptions& options,
                  Movement& movement) {
  const CommonPart rigid(matched, Removal::Tilt, true);
  rigid.removeFrom(matched);
  rigid.removeFromErrors(matched);
  for (const MatchedStation& m : matched) movement.stations[m.station].rest = m.dz;
  const LargestRest largest = largestRest(matched, common, options);
  movement.max_rest = largest.dz, movement.sigma_rest = largest.sigma, movement.rest_threshold = largest.threshold;
  movement.rest_azimuth = movement.stations[matched[largest.station].station].azimuth;
  movement.rest_significant = largest.moved;
}

void summarise(Movement& movement) {
  double squares = 0.0;
  for (const StationMovement& s : movement.stations) {
    if (!std::isfinite(s.dz)) continue;
    squares += s.dz * s.dz;
    movement.significant += s.significant ? 1 : 0;
    if (!(std::abs(s.dz) <= std::abs(movement.max))) movement.max = s.dz, movement.max_azimuth = s.azimuth;
  }
  movement.rms = std::sqrt(squares / static_cast<double>(movement.matched));
}

}  // namespace

bool Movement::moved() const {
  const bool whole = removal == Removal::Nothing && mean_significant;
  return whole || (removal != Removal::Tilt && tilt_significant) || rest_significant || significant > 0;
}

double StationMovement::lod95() const { return kNormal95 * sigma; }

const char* nameOf(Removal removal) {
  return removal == Removal::Nothing ? "none" : removal == Removal::Mean ? "mean" : "tilt";
}

void requireValid(const MovementOptions& options) { refuseFirst(firstError(options)); }

void requireErrors(const Epoch& epoch) {
  if (epoch.judgeable() > 0) return;
  refuse("standard errors of " + epoch.name, "none",
         epoch.levelled ? "a sigma column in the levelling's table: the standard error of each elevation"
                        : "sigma_z of its measured stations");
}

namespace {

/// Whether centres say whether it is the same tank: in a frame that both surveys share.
bool shareFrame(const Epoch& baseline, const MovementOptions& options) {
  return !baseline.levelled && !options.estimate_offset && options.azimuth_offset == 0.0;
}

}  // namespace

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

namespace {

/// Refuses surveys of different tanks, kinds or without errors.
void requireComparable(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  const Eigen::Vector2d center = current.levelled ? baseline.circle.center : current.circle.center;
  requireSameTank(baseline, current.name, {center, current.circle.radius}, options);
  requireSameKind(baseline, current);
  requireErrors(baseline);
  requireErrors(current);
}

/// The stations' movements with what is significant of them.
void takeFound(const Significance& found, const std::vector<MatchedStation>& matched, Movement& movement) {
  movement.threshold = found.threshold;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    StationMovement& s = movement.stations[matched[i].station];
    s.dz = matched[i].dz, s.sigma = found.sigmas[i], s.sigma_baseline = matched[i].sigma_baseline;
    s.significant = found.moved[i];
  }
}

}  // namespace

Movement compareEpochs(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  requireValid(options);
  Movement movement;
  movement.baseline = baseline.name;
  movement.removal = options.removal;
  movement.registration_error = options.registration_error;
  movement.registration_tilt = options.registration_tilt;
  for (const Epoch* epoch : {&baseline, &current}) {
    if (epoch->usable()) continue;
    movement.message = epoch->name + " holds no usable datum: " + epoch->status;
    return movement;
  }
  requireComparable(baseline, current, options);
  if (shareFrame(baseline, options) && !current.levelled)
    movement.centre_apart = (current.circle.center - baseline.circle.center).norm();
  const AzimuthOffset offset =
      options.estimate_offset ? estimateOffset(baseline, current, options) : AzimuthOffset{options.azimuth_offset, 0.0};
  movement.azimuth_offset = offset.value;
  movement.sigma_azimuth_offset = offset.sigma;
  Matching matching = matchStations(baseline, current, offset.value);
  std::vector<MatchedStation>& matched = matching.stations;
  movement.stations = stationsOf(baseline, current, matching, offset.value);
  movement.matched = matched.size();
  if (matched.size() < kFewestStations) {
    movement.message = "only " + std::to_string(matched.size()) + " stations are measured in both surveys, and " +
                       std::to_string(kFewestStations) + " are needed";
    return movement;
  }
  const double rim = options.registration_tilt * current.circle.radius;
  const MovementErrors errors = shownErrors(matched, baseline.levelled && current.levelled);
  widenErrors(matched, errors, options.correlation);
  movement.errors_shown = errors.shown, movement.errors_used = errors.scale;
  movement.shared_arc = errors.shared;
  const CommonMotion motion = commonMotion(matched, options.registration_error, rim);
  describeWhole(motion, errors.freedom_whole, current.circle.radius, movement);
  movement.rise_azimuth = azimuthIn(current, movement.tilt_direction - offset.value);
  const CommonErrors common{options.registration_error, rim, offset.sigma, errors.freedom};
  describeRest(matched, common, options, movement);
  const CommonPart part(matched, options.removal, true);
  part.removeFrom(matched);
  part.removeFromErrors(matched);
  const Significance found = findMoved(matched, common, options);
  takeFound(found, matched, movement);
  summarise(movement);
  return movement;
}

Movement countedAs(const Epoch& survey, double azimuth_offset, Movement movement) {
  const auto counted = [&](double direction) {
    constexpr double kRounding = 1e-9;
    const double azimuth = azimuthIn(survey, direction - azimuth_offset);
    return azimuth < kTwoPi - kRounding ? azimuth : 0.0;
  };
  const auto same = [&](const StationMovement& s) {
    return std::abs(std::remainder(counted(s.direction) - s.azimuth, kTwoPi)) < kSamePlace;
  };
  if (std::all_of(movement.stations.begin(), movement.stations.end(), same)) return movement;
  const auto again = [&](double azimuth) {
    const auto at = std::find_if(movement.stations.begin(), movement.stations.end(),
                                 [azimuth](const StationMovement& s) { return s.azimuth == azimuth; });
    return at == movement.stations.end() ? kUnknown : counted(at->direction);
  };
  movement.max_azimuth = again(movement.max_azimuth);
  movement.rest_azimuth = again(movement.rest_azimuth);
  movement.rise_azimuth = counted(movement.tilt_direction);
  for (StationMovement& s : movement.stations) s.azimuth = counted(s.direction);
  std::sort(movement.stations.begin(), movement.stations.end(),
            [](const StationMovement& a, const StationMovement& b) { return a.azimuth < b.azimuth; });
  return movement;
}

}  // namespace tank_datum
