#pragma once

#include <cstddef>

/// The inner loops of SurfaceRows: plain arrays, four rows at a time, compiled for AVX2 too, and chosen when the
/// program starts. No fused multiply-add and always the same lanes: the sums are the same to the last bit on every
/// machine.
namespace tank_datum {

/// Columns of `count` rows.
struct SurfaceColumns {
  const double *a, *t, *z;
  std::size_t count;
};

/// Sums of weight times the products of the letters after w; q is t squared.
struct SurfaceSums {
  double w, wa, wt, wq, waa, wat, waq, wtq, wqq, wz, waz, wtz, wqz;
};

SurfaceSums weightedSums(const SurfaceColumns& rows, const double* weights);

/// z less s0 + s1 a + s2 t + s3 t^2.
void residualsOf(const SurfaceColumns& rows, const double* solution, double* residuals);

/// As tukeyWeight of the residuals over the noise.
void tukeyWeights(const double* residuals, std::size_t count, double noise, double* weights);

}  // namespace tank_datum
