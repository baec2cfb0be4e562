#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/fit/circle.h"
#include "tank_datum/fit/harmonics.h"
#include "tank_datum/io/scan.h"

namespace TANK_DATUM_API tank_datum {

/// From which side of the shell the foundation was seen.
enum class Side { Outside, Inside };

struct LocateOptions {
  double min_radius = 2.0;              ///< the smallest tank to look for [m]
  double min_arc = 1.2217304763960306;  ///< the least seen arc of shell that makes a tank [rad], 70 degrees
  std::size_t sample_points = 500'000;  ///< bound of the thinned sample
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const LocateOptions& options);

/// A vertical cylinder standing in the scan, to the accuracy of the thinned sample.
struct Tank {
  Circle circle;  ///< of the shell near its foot, relative to the scan's origin [m]
  double rms = std::numeric_limits<double>::quiet_NaN();  ///< of the shell's cells about the circle [m]
  double coverage = 0.0;                                  ///< seen arc of the shell [rad]
  double height = 0.0;                                    ///< seen height of the shell [m]
  Side side = Side::Outside;
  PeriodicFit foot;             ///< shell foot against azimuth [m], coarse
  double resolution = 0.0;      ///< spacing of the sample the figures come from [m]
  bool has_foundation = false;  ///< a surface was seen that meets the foot
  bool strays = false;          ///< a good part of the scan's points float in the air, and are not to be fitted
  double near_foot = 0.0;       ///< share of the scan's rows within kNear of the foot, in radius and height

  double behind_share = 0.0;  ///< of what is seen of the shell, where walls of others stand behind it
  double behind = 0.0;        ///< how far behind it these stand, in the middle [m]

  static constexpr double kNear = 0.5;  ///< [m]

  double azimuthOf(const Eigen::Vector2d& p) const;
};

/// A circle on which walls stand, and why it is none of a tank's.
struct RejectedCircle {
  Circle circle;          ///< relative to the scan's origin [m]
  double coverage = 0.0;  ///< arc on which walls face the centre [rad]
  std::string reason;     ///< "its walls are flat, like a box's"
};

/// The tanks of a scan, best first: the one whose shell is seen along the longest arc [m].
///
/// Columns of the thinned sample that are filled over some height are walls; circles are drawn through three of them
/// and kept by the arc on which walls face the centre (RANSAC). A circle whose walls do not turn with the azimuth is a
/// box; one that encloses a taller one is a bund wall; one just outside of another and below its foot is a ringwall.
/// @param threads   0 means all cores; the tanks do not depend on it
/// @param rejected  where to put the circles that are no tanks, the longest seen arc first; may be null
std::vector<Tank> locateTanks(const Scan& scan, const LocateOptions& options, int threads = 0,
                              std::vector<RejectedCircle>* rejected = nullptr);

/// A tank whose circle is known (--tank X,Y,R); only side, foot and coverage are looked for.
std::optional<Tank> describeTank(const Scan& scan, const Circle& circle, const LocateOptions& options, int threads = 0);

}  // namespace tank_datum
