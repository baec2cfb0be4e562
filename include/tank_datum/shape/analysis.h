#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// Level of the datum over the stations whose z is known; NaN until computed.
struct Level {
  std::size_t measured = 0, interpolated = 0, missing = 0;
  double mean = kUnknown, min = kUnknown, max = kUnknown;  ///< [m]
  double min_azimuth = kUnknown, max_azimuth = kUnknown;   ///< as the user counts azimuths [rad]
  double range() const { return max - min; }
};

/// The paper's inclination: the largest difference of height between two ends of a diameter.
struct Antipodal {
  double max_h = kUnknown;     ///< h [m]
  double diameter = kUnknown;  ///< D, distance of the two stations in plan [m]
  double azimuth = kUnknown;   ///< of the higher end, as the user counts it [rad]
  double sigma = kUnknown;     ///< standard error of h [m]
  double angle() const;        ///< alpha = atan(h / D) [rad]
};

/// z = mean + slope_x (x - x0) + slope_y (y - y0), fitted by least squares; NaN until fitted.
struct Tilt {
  double mean = kUnknown;                                          ///< elevation of the plane at the centre [m]
  Eigen::Vector2d gradient = Eigen::Vector2d::Constant(kUnknown);  ///< [m/m]
  double sigma_slope = kUnknown;                                   ///< standard error of the slope [m/m]
  double standard_error = kUnknown;                                ///< of the regression, what a station departs by [m]
  double direction = kUnknown;  ///< towards the highest point, as the user counts azimuths [rad]
  double freedom = 0.0;         ///< degrees of freedom behind sigma_slope; 0: errors given
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(kUnknown);  ///< of the gradient
  double r2 = kUnknown;                                              ///< share of the variance that the plane explains
  double p_value = kUnknown;  ///< F test on 2 and N - 3 degrees of freedom, see fitTilt

  bool valid() const { return gradient.allFinite(); }
  double slope() const { return gradient.norm(); }
};

/// One wave of the datum round the tank, amplitude * cos(n * (azimuth - crest)).
struct Harmonic {
  int n = 0;
  double amplitude = kUnknown;  ///< [m]; of n = 0 the mean elevation
  double crest = kUnknown;      ///< azimuth of a highest point, below 2 pi / n [rad]; unknown for n = 0
  double sigma = kUnknown;      ///< standard error of the amplitude [m]
};

/// Out-of-plane settlement, U = z less the tilt plane, and its trigonometric regression (API ballot 653-1012).
struct OutOfPlane {
  int order = 0;                            ///< highest wave number fitted; 0: not fitted
  double adjusted_r2 = kUnknown;            ///< share of U's variance that the regression explains
  double rms = kUnknown;                    ///< of what it leaves, at the measured stations [m]
  double max_u = kUnknown;                  ///< largest |U| of a station [m]
  double max_u_azimuth = kUnknown;          ///< as the user counts it [rad]
  Interval95 u_interval;                    ///< of the largest |U| round the tank, analyse() gives it
  double max_curvature = kUnknown;          ///< largest |u''| of a station [1/m]
  double sigma_curvature = kUnknown;        ///< its standard error [1/m]
  Interval95 curvature_interval;            ///< of the largest |u''| round the tank, analyse() gives it
  double max_curvature_azimuth = kUnknown;  ///< [rad]
  std::vector<StationBending> stations;     ///< what the regression says of each; empty without one
  std::string message = "no out-of-plane settlement known";  ///< why there is no regression; empty when there is one

  bool valid() const { return order > 0; }
};

/// The classic out-of-plane rule of API 653 Annex B: S_i = |U_i - (U_{i-1} + U_{i+1}) / 2|; between points that are
/// not equally spaced, the distance of U_i from the chord of its neighbours.
struct SecondDifferences {
  int points = 0;                ///< survey points round the tank; 0: the rule does not apply
  int starts = 0;                ///< surveys of so many start angles, each with its own points
  double spacing = kUnknown;     ///< mean arc between points [m]
  std::vector<PlacedValue> all;  ///< every S_i of every start
  std::vector<double> spacings;  ///< L of each: the root of its two arcs' product [m]
  std::size_t worst = 0;         ///< the one largest beside its limit, which goes with L^2
  std::string message;           ///< why there are none, or what limits their use

  bool valid() const { return !all.empty(); }
};

/// A stretch of the shell between two changes of U's sign (Andreani et al.).
struct SettlementArc {
  double length = 0.0;  ///< [m]
  PlacedValue largest;  ///< |U| where it is largest
};

struct AnalysisOptions {
  TankFacts facts;
  int classic_points = 0;                        ///< survey points for the classic rule; 0: every 20 ft
  std::vector<Limit> limits = standardLimits();  ///< what the figures are judged by
  std::string limits_file;                       ///< where they were read from; empty: they come with the library
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const AnalysisOptions& options);

/// A settlement or a rise of one part of the ring that its waves and its errors do not explain.
struct LocalSettlement {
  double azimuth = kUnknown;  ///< of its middle, as the user counts azimuths [rad]
  double width = kUnknown;    ///< from where it begins to where it ends [rad]
  double height = kUnknown;   ///< of its middle above the mean of its ends, settlement negative [m]
  double sigma = kUnknown;    ///< [m]
};

/// How far the shell's top moves in or out of round by the settlement: (D H / 2) u'', the largest round the tank. A
/// floating roof needs that much room at its rim seal. Source: equation 6 of the white paper behind ballot 653-1012.
struct Ovality {
  PlacedValue largest;  ///< [m]
  Interval95 interval;  ///< of the largest round the tank [m]
};

/// What the datum's shape means.
struct Analysis {
  std::vector<Harmonic> harmonics;
  OutOfPlane out_of_plane;
  std::vector<LocalSettlement> local_settlements;  ///< of more than 64 stations
  SecondDifferences second_differences;
  std::vector<SettlementArc> arcs;
  PlacedValue level_9m, level_3m, level_total;  ///< of the foundation (API 650 7.5.5) [m]
  Ovality top_ovality;                          ///< where the shell's height is given
  double longest_gap = kUnknown;                ///< arc between neighbouring measured stations [m]
  std::vector<Measure> measures;                ///< the figures, as they go to the limits
  std::vector<Check> checks;
  Headline headline;                       ///< what the checks come to
  std::vector<LimitComparison> roundness;  ///< of the shell at each height that was seen, beside the same limits
  std::vector<std::string> notes;          ///< for every reader of the checks

  bool valid() const { return !checks.empty(); }
};

}  // namespace tank_datum
