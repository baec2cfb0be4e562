#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/fit/curves.h"

namespace TANK_DATUM_API tank_datum {

struct ShellOptions {
  std::vector<double> heights;    ///< above the datum [m], increasing; empty: 0.3 m and every `step` above that
  double step = 0.5;              ///< between heights [m]; with the courses' height all lie 0.3 m above a seam
  double half_band = 0.1;         ///< a height takes the points this far above and below it [m]
  double reach = 0.3;             ///< the shell is looked for this far from the tank's circle [m]
  std::size_t cell_points = 100;  ///< of half a degree and one height at most this many points are kept
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const ShellOptions& options);

/// The shell at one height and azimuth.
struct ShellPoint {
  double azimuth = kUnknown;    ///< as the user counts it [rad]
  double height = kUnknown;     ///< above the datum here [m]
  double radius = kUnknown;     ///< from the centre of the datum's circle [m]
  double deviation = kUnknown;  ///< from the circle through this height, positive outwards [m]
  double offset = kUnknown;     ///< of the radius from that at the lowest height seen here [m]
  double sigma = kUnknown;      ///< standard error of the radius [m]
  std::size_t points = 0;       ///< behind it
};

/// The shell at one height against the circle that fits it best. Extremes are those of the shell smoothed over as wide
/// an arc as its shape allows, so that the largest of many noisy values is not taken for the shell's.
struct Roundness {
  double height = kUnknown;         ///< above the datum [m]
  Circle circle;                    ///< least squares, every station seen the same [m]
  double max_deviation = kUnknown;  ///< outwards [m]
  double min_deviation = kUnknown;  ///< inwards, negative [m]
  double azimuth = kUnknown;        ///< of the larger of the two [rad]
  double sigma = kUnknown;          ///< its standard error [m]
  double rise = 0.0;                ///< of it, by which it is more than at the places that were looked at [m]
  double may_rise = 0.0;            ///< by which it may be still more, if it is as narrow as these allow [m]
  double doubted = 0.0;             ///< the largest of what may be the shell or something before it [m]
  std::size_t stations = 0;         ///< at which the shell is seen at this height
  double widest_gap = kUnknown;     ///< arc between two of them [m]

  double largest() const { return std::max(max_deviation, -min_deviation); }  ///< [m]
};

/// How far the shell stands off the vertical at one azimuth, positive outwards.
struct Plumbness {
  double azimuth = kUnknown;                        ///< as the user counts it [rad]
  double direction = kUnknown;                      ///< counter-clockwise from +x [rad]
  double height = kUnknown;                         ///< between the lowest and the highest place seen here [m]
  double offset = kUnknown, sigma = kUnknown;       ///< of the highest from the lowest, smoothed along the shell [m]
  double slope = kUnknown, sigma_slope = kUnknown;  ///< line through all heights [m/m]; no sigma through two
  double top = kUnknown;                            ///< the highest place seen, above the datum [m]
};

/// The lean of the tank as a whole, what the slopes round it have in common.
struct Lean {
  Eigen::Vector2d gradient = Eigen::Vector2d::Constant(kUnknown);  ///< of the axis with height [m/m]
  double sigma = kUnknown;                                         ///< standard error of either component [m/m]
  double direction = kUnknown;  ///< towards which the top leans, as the user counts azimuths [rad]
  double height = kUnknown;     ///< over which it was seen [m]

  bool valid() const { return gradient.allFinite(); }
  double slope() const { return gradient.norm(); }
  double offset() const { return height * slope(); }  ///< of the top [m]
};

/// What the scan holds of the shell above the datum; empty until surveyed.
struct ShellSurvey {
  std::string message;               ///< why there is nothing
  std::vector<ShellPoint> points;    ///< by height, then by station
  std::vector<Roundness> roundness;  ///< one per height seen round enough of the tank, lowest first
  std::vector<Roundness> arcs;       ///< one per other height, against the nearest of those circles, moved as it leans
  std::vector<Plumbness> plumbness;  ///< one per station seen at two heights or more
  Lean lean;

  bool valid() const { return !points.empty(); }
  const Roundness* foot() const;            ///< the highest at one foot above the bottom or below; null when not seen
  const Roundness* worstAbove() const;      ///< higher up, arcs too, the largest deviation; null when not seen
  const Plumbness* worstPlumbness() const;  ///< the offset surely (95 %) largest either way; or null
};

}  // namespace tank_datum
