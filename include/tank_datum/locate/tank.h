#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/fit/curves.h"
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

  double ringwall_width = 0.0;   ///< how far the face of one stands out, below the shell; 0 where none is seen [m]
  double ringwall_height = 0.0;  ///< of that face, from the ground to the foot of the shell [m]

  /// Of a wall no higher than a ringwall's face: the share of what is seen of it behind whose top something lies, as
  /// the top of a ringwall and the shell upon it do, or the soil that fills a planter; not known of a higher one, nor
  /// of one seen from inside.
  double low_wall = std::numeric_limits<double>::quiet_NaN();

  double behind_share = 0.0;  ///< of what is seen of the shell, where walls of others stand behind it
  double behind = 0.0;        ///< how far behind it these stand, in the middle [m]

  static constexpr double kNear = 0.5;  ///< [m]

  /// Whether the shell was taken to begin where a wall steps back.
  bool standsOnRingwall() const { return ringwall_width > 0.0; }
  double azimuthOf(const Eigen::Vector2d& p) const;
};

struct CropOptions {
  double reach = 0.5;  ///< half-width of the ring in radius and height [m]; at most half of the radius
  std::size_t search_points = 1'000'000;  ///< the ring is thinned to at most this many for the search of edge points
  std::size_t fit_points = 4'000'000;     ///< of more points in the ring an even share is kept for the fits
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const CropOptions& options);

/// The points of a scan near the datum, about the tank's centre.
struct Ring {
  Points points;        ///< the scan's points in the ring, or an even share of them, relative to the scan's origin [m]
  Points search;        ///< these thinned by voxels to an even spacing, for the search of edge points
  double reach = 0;     ///< half-width used [m]
  double rounding = 0;  ///< step that elevations were rounded to, where it is coarse [m]
  ScanCounts counts;    ///< what the pass over the scan met
  std::vector<SetupKey> setups;  ///< those with points in the ring, in the order of the scan
  std::vector<std::uint16_t>
      point_setups;  ///< of each point the index of its setup; empty when there is one setup only

  /// How many setups the points can be told apart by.
  std::size_t setupCount() const { return point_setups.empty() ? 1 : setups.size(); }
  /// Index of a point's setup.
  std::uint16_t setupOf(std::size_t point) const {
    return point_setups.empty() ? std::uint16_t{0} : point_setups[point];
  }
};

}  // namespace tank_datum
