#include "movement/movement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/normal95.h"
#include "core/portable_math.h"
#include "core/refusal.h"
#include "core/statistics.h"
#include "core/units.h"
#include "movement/azimuth_offset.h"
#include "movement/epoch_matching.h"
#include "movement/movement_errors.h"
#include "movement/movement_significance.h"
#include "movement/same_tank.h"
#include "movement/unmoved.h"
#include "tank_datum/core/error.h"
#include "tank_datum/datum.h"
#include "tank_datum/fit/curves.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestStations = 8;  ///< stations in common

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
  movement.mean_significant = std::abs(motion.mean) > studentQuantile(freedom, kNormalPerTest) * motion.sigma_mean;
  const double rim = motion.rim.norm();
  movement.tilt_change = rim / radius;
  const Eigen::Vector2d along = rim > 0.0 ? motion.rim.normalized() : Eigen::Vector2d(1.0, 0.0);
  movement.sigma_tilt_change = std::sqrt(along.dot(motion.covariance * along)) / radius;
  movement.tilt_direction = withinTurn(portable::atan2(motion.rim.y(), motion.rim.x()));
  movement.tilt_p_value = tiltPValue(motion, freedom);
  movement.tilt_significant = movement.tilt_p_value < kAlarmsPerTest;
}

/// What is left of the movement without that of the tank as a rigid body, and its largest.
void describeRest(const std::vector<MatchedStation>& rest, const std::vector<double>& drawn, double turn,
                  Movement& movement) {
  for (const MatchedStation& m : rest) movement.stations[m.station].rest = m.dz;
  const LargestRest largest = largestRest(rest, drawn, turn);
  movement.max_rest = largest.dz, movement.sigma_rest = largest.sigma, movement.rest_threshold = largest.threshold;
  movement.rest_azimuth = movement.stations[rest[largest.station].station].azimuth;
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
  if (removal == Removal::Auto) return "auto";
  return removal == Removal::Nothing ? "none" : removal == Removal::Mean ? "mean" : "tilt";
}

void requireValid(const MovementOptions& options) { refuseFirst(firstError(options)); }

namespace {

/// The stations' movements with what is significant of them.
void takeFound(const Significance& found, const std::vector<MatchedStation>& matched, Movement& movement) {
  movement.threshold = found.threshold;
  for (std::size_t i = 0; i < matched.size(); ++i) {
    StationMovement& s = movement.stations[matched[i].station];
    s.dz = matched[i].dz, s.sigma = found.sigmas[i], s.sigma_baseline = matched[i].sigma_baseline;
    s.significant = found.moved[i];
  }
}

/// @param removal  never Removal::Auto
Movement compare(const Epoch& baseline, const Epoch& current, const MovementOptions& options, Removal removal) {
  requireValid(options);
  Movement movement;
  movement.baseline = baseline.name;
  movement.removal = removal;
  movement.rod_taken_out = options.removal == Removal::Auto && movement.removal == Removal::Mean;
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
  const MovementErrors errors = shownErrors(matched);
  widenErrors(matched, errors, options.correlation);
  movement.errors_shown = errors.shown, movement.errors_used = errors.scale;
  movement.shared_arc = errors.shared;
  const CommonMotion motion = commonMotion(matched, options.registration_error, rim);
  describeWhole(motion, errors.freedom_whole, current.circle.radius, movement);
  requireSameSurface(baseline, current, movement);
  movement.rise_azimuth = azimuthIn(current, movement.tilt_direction - offset.value);
  const CommonErrors common{options.registration_error, rim, offset.sigma, errors.freedom};
  const Removed rest(matched, Removal::Tilt, true), left(matched, movement.removal, true);
  const UnmovedDraws draws = drawUnmoved(matched, rest, left, common, options.correlation);
  describeRest(rest.stations, draws.largest_rest, common.turn, movement);
  takeFound(findMoved(left.stations, draws.dz, common), left.stations, movement);
  summarise(movement);
  movement.fits_turned = movement.rest_significant && fitsTurned(baseline, current, options);
  return movement;
}

}  // namespace

Movement compareEpochs(const Epoch& baseline, const Epoch& current, const MovementOptions& options) {
  return compare(baseline, current, options, removalOf(baseline, current, options));
}

std::vector<Movement> compareWithFirst(const std::vector<Epoch>& surveys, const MovementOptions& options) {
  const Removal removal = removalOf(surveys, options);
  std::vector<Movement> movements;
  for (std::size_t i = 1; i < surveys.size(); ++i)
    movements.push_back(compare(surveys.front(), surveys[i], options, removal));
  return movements;
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
