#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/placed_value.h"
#include "tank_datum/stations/stations.h"

namespace TANK_DATUM_API tank_datum {

/// One wave of the datum round the tank, amplitude * cos(n * (azimuth - crest)).
struct Harmonic {
  int n = 0;
  double amplitude = kUnknown;  ///< [m]; of n = 0 the mean elevation
  double crest = kUnknown;      ///< azimuth of a highest point, below 2 pi / n [rad]; unknown for n = 0
  double sigma = kUnknown;      ///< standard error of the amplitude [m]
};

/// The waves n = 0, 1, ... up to the shortest half-wave of 20 ft, six at least, as far as the stations can tell them
/// apart: all fitted together, by weights, to the measured stations, so that a gap costs certainty and no bias.
/// @param radius  of the tank [m]
std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius);

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
  std::string message = "no out-of-plane settlement known";  ///< why there is no regression; empty when there is one

  bool valid() const { return order > 0; }
};

/// u(l) = sum over k = 2..order of a_k cos(k l / R) + b_k sin(k l / R): four waves at least, none with a half-wave
/// shorter than 20 ft, and of those between up to the highest whose addition still raises the adjusted R2. For more
/// than 64 measured stations on a tank of 18.6 m or more. Fills u_fit, curvature and their standard errors of every
/// station whose z is known; u must be there. Standard errors grow by what the residuals show beyond those of the
/// stations; noise that neighbours share is in it. Source: API ballot 653-1012 and its white paper; STANDARDS 2.
OutOfPlane fitOutOfPlane(std::vector<Station>& stations, double radius);

/// The longest arc between neighbouring stations that have a z [m]; the whole circumference when fewer than two have.
double longestGap(const std::vector<Station>& stations, double radius);

}  // namespace tank_datum
