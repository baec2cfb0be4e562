#pragma once

#include <vector>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// The waves n = 0, 1, ... up to the shortest half-wave of 20 ft, six at least, as far as the stations can tell them
/// apart: all fitted together, by weights, to the measured stations, so that a gap costs certainty and no bias.
/// @param radius  of the tank [m]
std::vector<Harmonic> harmonicsOf(const std::vector<Station>& stations, double radius);

/// u(l) = sum over k = 2..order of a_k cos(k l / R) + b_k sin(k l / R): four waves at least, none with a half-wave
/// shorter than 20 ft, and of those between up to the highest whose addition still raises the adjusted R2. For more
/// than 64 measured stations on a tank of 18.6 m or more, whose u must be there. Standard errors grow by what the
/// residuals show beyond those of the stations; noise that neighbours share is in it. Source: API ballot 653-1012 and
/// its white paper; STANDARDS 2.
OutOfPlane fitOutOfPlane(const std::vector<Station>& stations, double radius);

/// The longest arc between neighbouring stations that are measured [m]: what bridges a gap does not show what is in it.
/// The whole circumference when fewer than two are.
double longestGap(const std::vector<Station>& stations, double radius);

}  // namespace tank_datum
