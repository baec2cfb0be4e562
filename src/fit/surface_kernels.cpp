#include "fit/surface_kernels.h"

#include <cstring>

#include "core/cpu_dispatch.h"

namespace tank_datum {
namespace {

constexpr std::size_t kLanes = 4;
constexpr std::size_t kSums = sizeof(SurfaceSums) / sizeof(double);

using Doubles = double __attribute__((vector_size(8 * kLanes)));

}  // namespace

TANK_DATUM_CPU_DISPATCH
SurfaceSums weightedSums(const SurfaceColumns& rows, const double* weights) {
  Doubles w{}, a{}, t{}, z{};
  Doubles sw{}, sa{}, st{}, sq{}, saa{}, sat{}, saq{}, stq{}, sqq{}, sz{}, saz{}, stz{}, sqz{};
  for (std::size_t begin = 0; begin < rows.count; begin += kLanes) {
    if (rows.count - begin >= kLanes) {
      std::memcpy(&w, weights + begin, sizeof w);
      std::memcpy(&a, rows.a + begin, sizeof a);
      std::memcpy(&t, rows.t + begin, sizeof t);
      std::memcpy(&z, rows.z + begin, sizeof z);
    } else {
      w = a = t = z = Doubles{};
      for (std::size_t i = begin; i < rows.count; ++i) {
        w[i - begin] = weights[i], a[i - begin] = rows.a[i], t[i - begin] = rows.t[i], z[i - begin] = rows.z[i];
      }
    }
    const Doubles q = t * t, wa = w * a, wt = w * t, wq = w * q;
    sw += w, sa += wa, st += wt, sq += wq;
    saa += wa * a, sat += wa * t, saq += wa * q, stq += wt * q, sqq += wq * q;
    sz += w * z, saz += wa * z, stz += wt * z, sqz += wq * z;
  }
  const Doubles sums[kSums] = {sw, sa, st, sq, saa, sat, saq, stq, sqq, sz, saz, stz, sqz};
  double added[kSums];
  for (std::size_t i = 0; i < kSums; ++i) added[i] = (sums[i][0] + sums[i][1]) + (sums[i][2] + sums[i][3]);
  SurfaceSums result{};
  std::memcpy(&result, added, sizeof result);
  return result;
}

TANK_DATUM_CPU_DISPATCH
void residualsOf(const SurfaceColumns& rows, const double* solution, double* residuals) {
  const double s0 = solution[0], s1 = solution[1], s2 = solution[2], s3 = solution[3];
  for (std::size_t i = 0; i < rows.count; ++i) {
    const double t = rows.t[i];
    residuals[i] = rows.z[i] - (s0 + s1 * rows.a[i] + s2 * t + s3 * (t * t));
  }
}

TANK_DATUM_CPU_DISPATCH
void tukeyWeights(const double* residuals, std::size_t count, double noise, double* weights) {
  constexpr double kCutoff = 4.685;  // 95 % as efficient as the mean of normal deviates
  const double scale = 1.0 / (kCutoff * noise);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = residuals[i] * scale, w = 1.0 - u * u;
    weights[i] = w > 0.0 ? w * w : 0.0;
  }
}

}  // namespace tank_datum
