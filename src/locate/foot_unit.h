#pragma once

namespace tank_datum {

/// What the lengths of a foot - plates, ringwalls, welds, how far a datum is looked for - are multiples of [m]: metres,
/// on everything between a drum and the largest tank there is. A scan of a tank in which a radius is smaller or larger
/// is in other units than it says, and they are in proportion; but of things so small that the scan has few points to a
/// radius, tins on a table, nothing finer than the points can be looked for anyway.
inline double footUnit(double radius, double spacing) {
  constexpr double kDrum = 1.0, kLargest = 100.0, kUsual = 10.0;  // radii [m]
  constexpr double kFew = 60.0;                                   // points to a radius
  if ((radius >= kDrum && radius <= kLargest) || (radius < kDrum && radius < kFew * spacing)) return 1.0;
  return radius / kUsual;
}

}  // namespace tank_datum
