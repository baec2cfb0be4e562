#pragma once

#include <vector>

#include "options.h"

namespace tank_datum::synth {

/// A value and its derivative by azimuth.
struct Curve {
  double value = 0.0, rate = 0.0;
  void add(double v, double r) {
    value += v;
    rate += r;
  }
};

double tiltSlope(const TankOptions& tank);

/// Datum elevation: base + tilt + harmonics - dips.
Curve datumCurve(const TankOptions& tank, double azimuth);

/// The shell's harmonics with the lobes among them, their phases drawn from the seed and their size settled.
std::vector<ShellHarmonic> shellHarmonics(const TankOptions& tank, std::uint64_t seed);

/// The harmonics that vary the width of the annular plate.
std::vector<ShellHarmonic> lipHarmonics(const TankOptions& tank, std::uint64_t seed);

/// The slope of the annular plate, rising outwards [1].
Curve plateSlopeCurve(const TankOptions& tank, double azimuth);

/// How far ringwall, crown and slab stand above their usual height [m].
Curve sectorCurve(const TankOptions& tank, double azimuth);

/// Sum of amplitude * growth^power * cos(n * azimuth - phase).
Curve harmonicCurve(const std::vector<ShellHarmonic>& harmonics, double azimuth, bool growth);

/// Signed difference of two azimuths in -pi .. pi.
double azimuthDifference(double a, double b);

}  // namespace tank_datum::synth
