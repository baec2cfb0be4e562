#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/portable_math.h"
#include "core/units.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

constexpr double kWidestBracket = 2.0 * kDegree;  ///< neighbours between which an elevation is interpolated
constexpr double kSamePlace = 1e-6;               ///< [rad], 0.03 mm at 30 m

/// A station measured in both surveys.
struct MatchedStation {
  std::size_t station = 0;      ///< its index in the survey whose station it is
  double direction = 0.0;       ///< in the baseline's frame [rad]
  double dz = 0.0;              ///< current less baseline [m]
  double sigma = 0.0;           ///< from both sigmas [m]
  double sigma_baseline = 0.0;  ///< the baseline's part of it [m]
  double window = 0.0;          ///< the wider of the arcs that the two elevations come from [rad]
  double slope = 0.0;           ///< of the interpolated elevation along the direction [m/rad]
  /// What errors of many stations make of its error, one sigma of each, first the baseline's [m].
  Eigen::VectorXd shared;
  Eigen::Index shared_baseline = 0;  ///< how many of these are the baseline's

  /// The part of sigma that is the station's own [m].
  double own() const { return std::sqrt(std::fmax(0.0, sigma * sigma - shared.squaredNorm())); }
  /// The part of sigma_baseline that is the station's own [m].
  double ownOfBaseline() const {
    return std::sqrt(std::fmax(0.0, square(sigma_baseline) - square(sharedOfBaseline())));
  }
  /// The part of sigma_baseline that is shared [m].
  double sharedOfBaseline() const { return shared.head(shared_baseline).norm(); }
};

/// Stations measured in both surveys, by direction.
struct Matching {
  bool of_baseline = false;  ///< whose stations they are: the other survey's elevations are interpolated at them
  std::vector<MatchedStation> stations;
};

/// Matches the surveys when the current one is turned by `offset` [rad]: at the current survey's stations, or at the
/// baseline's where that compares more of them.
Matching matchStations(const Epoch& baseline, const Epoch& current, double offset);

/// All dz [m].
Eigen::VectorXd dzOf(const std::vector<MatchedStation>& stations);

/// Of the arcs that elevations come from [rad].
double medianWindow(const std::vector<MatchedStation>& stations);

/// Takes a common height or tilt, fitted with weights 1/sigma^2, from dz.
class CommonPart {
 public:
  /// @param robust  stations that stand out from the rest do not count (Tukey's biweight from least absolute
  ///                deviations), so that a sector that moved does not move the others
  CommonPart(const std::vector<MatchedStation>& stations, Removal removal, bool robust);
  /// The dz of its stations without it [m].
  Eigen::VectorXd without(Eigen::VectorXd dz) const;
  /// From dz.
  void removeFrom(std::vector<MatchedStation>& stations) const;
  /// From what the stations share of their errors, and so from their sigmas.
  void removeFromErrors(std::vector<MatchedStation>& stations) const;

 private:
  Eigen::MatrixXd rows_, fit_;  ///< one row per station; from dz to the coefficients
};

/// Stations without a common part.
struct Removed {
  CommonPart part;
  std::vector<MatchedStation> stations;  ///< dz and errors without it

  Removed(std::vector<MatchedStation> given, Removal removal, bool robust)
      : part(given, removal, robust), stations(std::move(given)) {
    part.removeFrom(stations);
    part.removeFromErrors(stations);
  }
};

/// A direction as a survey counts azimuths, from where its own zero is and whichever way round [rad].
double azimuthIn(const Epoch& epoch, double direction);

}  // namespace tank_datum
