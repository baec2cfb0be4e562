#pragma once

#include <algorithm>
#include <cmath>

namespace tank_datum {

/// Sums over points of a section, for the line through them: heights against distances [m].
struct LineSums {
  double n = 0, d = 0, z = 0, dd = 0, dz = 0, zz = 0;

  void add(double at, double height) { add({1.0, at, height, at * at, at * height, height * height}); }
  void add(const LineSums& o) { n += o.n, d += o.d, z += o.z, dd += o.dd, dz += o.dz, zz += o.zz; }

  double distance() const { return d / n; }
  double height() const { return z / n; }
  double slope() const { return products() / squares(); }
  double sigmaSlope() const { return std::sqrt(misfit() / std::max(1.0, n - 2.0) / squares()); }
  /// Share of the heights' squares about their mean that the line explains.
  double explained() const { return 1.0 - misfit() / heightSquares(); }

 private:
  double squares() const { return dd - d * d / n; }
  double products() const { return dz - d * z / n; }
  double heightSquares() const { return zz - z * z / n; }
  double misfit() const { return std::max(0.0, heightSquares() - products() * slope()); }
};

}  // namespace tank_datum
