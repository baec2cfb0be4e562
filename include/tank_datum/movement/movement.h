#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/limits/limits.h"

namespace TANK_DATUM_API tank_datum {

struct Datum;
enum class Method;

/// A measured elevation of the datum.
struct Elevation {
  double azimuth = kUnknown;    ///< as the survey counts it [rad]
  double direction = kUnknown;  ///< counter-clockwise from +x about the fitted centre [rad]
  double z = kUnknown;          ///< in the scan's own frame [m]
  double sigma_z = kUnknown;    ///< standard error [m]
  double window = kUnknown;     ///< arc along which the points behind z lie; NaN: at the station alone [rad]
  /// What errors that all stations share make of its error, one sigma of each [m]: a column of the covariance's
  /// factors.
  std::vector<double> shared = {};
};

/// One survey of a tank, as far as surveys are compared.
struct Epoch {
  std::string name;                 ///< where it was read from
  std::string status;               ///< "ok", "partial": usable
  std::string method;               ///< what z is
  std::string surface;              ///< the foundation surface that was intersected; else empty
  Circle circle;                    ///< in the scan's own frame [m]
  std::vector<Elevation> stations;  ///< every one in order; z is NaN where it was not measured
  bool levelled = false;            ///< elevations typed in: its azimuths are about its own centre, (0, 0)
  std::string date = {};            ///< of the survey, as whoever made it says: "2026-11-03"; or empty
  std::vector<Check> checks = {};   ///< figures beside their limits

  bool usable() const { return status == "ok" || status == "partial"; }
  std::size_t judgeable() const;  ///< measured stations with a standard error
};

/// Reads a datum.json, or the one in a result folder. Its `input.kind` says whether it is of a levelling; without one
/// it is of a scan.
/// @throws Error (File) what cannot be read, or is no datum.json with its stations
Epoch readEpoch(const std::string& path);

/// The survey in a result, of a scan or of a levelling.
Epoch epochOf(const Datum& datum, Method method, const std::string& name);

/// What is taken from the differences before they are judged.
enum class Removal {
  Auto,     ///< nothing; between a levelling and a scan the mean, since a rod stands elsewhere than a scan's datum
  Nothing,  ///< both surveys hang on the same benchmarks
  Mean,     ///< the common height: settlement of the whole is not seen
  Tilt,     ///< height and tilt: neither is seen, whatever the scanners' levels
};

/// The names used at the command line and in files: "auto", "none", "mean", "tilt".
const char* nameOf(Removal removal);

struct MovementOptions {
  Removal removal = Removal::Auto;
  double registration_error = 0.0;  ///< 1 sigma of a height common to all stations, left after the removal [m]
  double registration_tilt = 0.0;   ///< 1 sigma of a tilt about either level axis, left after it [rad]
  double azimuth_offset = 0.0;      ///< of the current survey's frame: added to its directions [rad]
  bool estimate_offset = false;     ///< find the azimuth offset by the datum's shape out of plane instead
  double correlation = 0.0;         ///< arc within which stations share points; 0: as the surveys say themselves [rad]
  double radius_difference = 0.05;  ///< surveys whose radii differ by more are of different tanks [m]
  double centre_distance = 0.25;    ///< the same of the centres, in a common frame [m]
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const MovementOptions& options);

/// The movement of one station.
struct StationMovement {
  double azimuth = kUnknown;         ///< as the current survey counts it [rad]
  double direction = kUnknown;       ///< in the baseline's frame [rad]
  double dz = kUnknown;              ///< current less baseline, after the removal [m]; NaN where either is not measured
  double rest = kUnknown;            ///< current less baseline without settlement and tilt of the whole [m]
  double sigma = kUnknown;           ///< standard error of dz, the registration's included [m]
  double sigma_baseline = kUnknown;  ///< the baseline's part of it [m]
  bool significant = false;          ///< moved: anywhere on an unmoved tank in 1.25 % of comparisons

  double lod95() const;  ///< 95 % level of detection of this station alone [m]
};

/// Movement of a tank's datum between two surveys.
struct Movement {
  std::string baseline;  ///< name of the earlier survey
  Removal removal = Removal::Nothing;
  double registration_error = 0.0;    ///< as given [m]
  double registration_tilt = 0.0;     ///< as given [rad]
  double azimuth_offset = 0.0;        ///< as given or estimated [rad]
  double sigma_azimuth_offset = 0.0;  ///< its standard error; 0 when given [rad]
  bool rod_taken_out = false;         ///< with the mean, as of the surveys some are levellings (Removal::Auto)
  bool fits_turned = false;           ///< moved, but not if the later survey counts its azimuths from elsewhere
  double centre_apart = kUnknown;     ///< of the two tanks' centres in a frame that both surveys share [m]
  double errors_shown = 1.0;          ///< scatter of the differences over the given sigmas
  double errors_used = 1.0;           ///< what the given sigmas were multiplied by: that, where it is above 1 and error
  double shared_arc = 0.0;            ///< arc within which the differences show shared errors [rad]
  double mean = kUnknown, sigma_mean = kUnknown;  ///< settlement of the whole, before the removal [m]
  bool mean_significant = false;                  ///< at 98.75 %: one of four tests
  double tilt_change = kUnknown;                  ///< slope of the change of tilt, before the removal [m/m]
  double sigma_tilt_change = kUnknown;            ///< along its direction [m/m]
  double tilt_direction = kUnknown;               ///< towards the part that rose, in the baseline's frame [rad]
  double tilt_p_value = kUnknown;  ///< test on 2 degrees of freedom: chi-square, or F where the sigmas are estimated
  bool tilt_significant = false;   ///< p < 0.0125
  double rise_azimuth = kUnknown;  ///< the same direction as the current survey counts it [rad]
  double max_rest = kUnknown;      ///< the rest of the largest magnitude, out of plane [m]
  double sigma_rest = kUnknown;    ///< its standard error [m]
  double rest_azimuth = kUnknown;  ///< where [rad]
  double rest_threshold = 0.0;     ///< of its magnitude in its standard errors: 98.75 % of unmoved tanks show less
  bool rest_significant = false;   ///< whether some are beyond it, no single ones among others
  double threshold = kUnknown;     ///< of the largest standardised window mean on an unmoved tank, 98.75 %
  std::vector<StationMovement> stations;  ///< of one survey, in its order: the current one's, or the sparser baseline's
  std::size_t matched = 0;                ///< stations measured in both
  std::size_t significant = 0;
  double max = kUnknown;          ///< dz of the largest magnitude [m]
  double max_azimuth = kUnknown;  ///< where [rad]
  double rms = kUnknown;          ///< of dz [m]
  std::string message;            ///< why there is none

  bool valid() const { return matched > 0 && message.empty(); }
  /// Whether anything that was not removed has moved significantly: of unmoved tanks at most 5 % have.
  bool moved() const;
};

/// Compares two surveys of one tank, scanned or levelled, at the stations of the current one; where the baseline's lie
/// too far apart for that, at the baseline's. The other survey's elevations are interpolated there between neighbours
/// at most 2 degrees apart; stations without such neighbours, or without a standard error, are not compared. Of a
/// levelling neither centre nor foundation surface is known, so they are not compared either: its azimuths are taken
/// about the tank's centre, and its heights differ from a scan's by a constant, since the rod stands on chime or bottom
/// projection (Removal::Auto).
/// @throws Error (Option) a refused option; surveys of different tanks, units, methods or foundation surfaces; a survey
///         without any standard error
Movement compareEpochs(const Epoch& baseline, const Epoch& current, const MovementOptions& options);

/// Each survey after the first compared with it, as compareEpochs does. What is taken out of the differences of one is
/// taken out of all, so that they make one course.
/// @throws Error (Option) as compareEpochs
std::vector<Movement> compareWithFirst(const std::vector<Epoch>& surveys, const MovementOptions& options);

/// The same movement with its azimuths as another survey counts them, its stations in that order: movements since one
/// baseline that are shown together.
/// @param azimuth_offset  of that survey's frame from the baseline's [rad]
Movement countedAs(const Epoch& survey, double azimuth_offset, Movement movement);

/// One place of the datum through all surveys.
struct StationHistory {
  double azimuth = kUnknown;             ///< as the last survey counts it [rad]
  double direction = kUnknown;           ///< in the baseline's frame [rad]
  std::vector<StationMovement> surveys;  ///< its movement at each survey after the baseline; dz NaN where unknown
  double rate = kUnknown;                ///< least-squares slope of the elevation against time [m per unit of time]
  double sigma_rate = kUnknown;          ///< its standard error: from the surveys' own, or from more scatter

  bool significant = false;  ///< of all places shown at once: some unmoved one is in at most 5 % of tanks

  double lod95() const;  ///< 95 % level of detection of the rate, of this place alone
};

/// The movements since one baseline, place by place: at the stations of the last survey that was compared. Other
/// surveys are interpolated between stations at most 2 degrees apart, as in compareEpochs; a place that a survey has
/// not seen has a rate from the others, if two surveys are left.
/// @param movements  in time order, of one baseline
/// @param times      of the baseline and then of each survey, increasing: one more than movements
/// @throws Error (Option) when the times are not that
std::vector<StationHistory> historiesOf(const std::vector<Movement>& movements, const std::vector<double>& times);

/// Whether and when a figure comes to its limit.
enum class Approach {
  Beyond,      ///< it is beyond its limit at the last survey
  Reached,     ///< it rises: within an interval of dates
  NotBefore,   ///< it may rise or fall: not before a date
  NotInSight,  ///< not within two centuries
  Away,        ///< it falls
};

/// The names used in files: "beyond", "reached", "not_before", "not_in_sight", "away".
const char* nameOf(Approach approach);

/// How a judged figure goes towards its limit.
struct LimitRate {
  Check check;                               ///< of the last survey
  double rate = kUnknown, sigma = kUnknown;  ///< slope against time and its standard error [unit of the check per year]
  Approach approach = Approach::NotInSight;
  double expected = kUnknown;                     ///< where the line meets the limit [decimal year]
  double earliest = kUnknown, latest = kUnknown;  ///< 95 % interval of it [decimal years]; latest NaN: perhaps never
};

/// The rates of all judged figures against their limits, the one whose limit may be reached first before the others.
struct LimitRates {
  std::vector<LimitRate> rates;
  std::string none;  ///< why there are none, a key of the report's words: "limit_rate.no_dates", ...
};

/// Weighted least squares of each figure that was judged at the last survey and at another against the surveys' dates.
/// Where the figures scatter significantly more about the line than their standard errors say, that is used, with
/// Student's t. The dates at which the 95 % band of the line meets the limit are the interval (E. C. Fieller, J. R.
/// Statist. Soc. B 16, 1954). The limit is that of the last survey.
/// @param surveys  in time order
LimitRates limitRatesOf(const std::vector<Epoch>& surveys);

}  // namespace tank_datum
