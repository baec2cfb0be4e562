#include "fit/surface_rows.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/statistics.h"
#include "fit/surface_kernels.h"

namespace tank_datum {

void SurfaceRows::reserve(std::size_t rows) {
  for (auto* column : {&a_, &t_, &z_}) column->reserve(rows);
}

void SurfaceRows::add(double a, double t, double z) {
  a_.push_back(a);
  t_.push_back(t);
  z_.push_back(z);
}

void SurfaceRows::close() {
  weights_.assign(size(), 1.0);
  residuals_.resize(size());
}

SurfaceRows::Equations SurfaceRows::equations() const {
  const SurfaceSums s = weightedSums({a_.data(), t_.data(), z_.data(), size()}, weights_.data());
  Equations e;
  e.matrix << s.w, s.wa, s.wt, s.wq,  //
      s.wa, s.waa, s.wat, s.waq,      //
      s.wt, s.wat, s.wq, s.wtq,       //
      s.wq, s.waq, s.wtq, s.wqq;
  e.right << s.wz, s.waz, s.wtz, s.wqz;
  e.weight = s.w;
  return e;
}

double SurfaceRows::residualsFrom(const Eigen::Vector4d& solution) {
  residualsOf({a_.data(), t_.data(), z_.data(), size()}, solution.data(), residuals_.data());
  return robustSigma(residuals_, 0.0);
}

void SurfaceRows::weigh(double noise) { tukeyWeights(residuals_.data(), size(), noise, weights_.data()); }

std::optional<SurfaceFit> fitRobustly(SurfaceRows& rows, const SurfacePrior& prior) {
  constexpr double kLeastNoise = 1e-7;  // m
  SurfaceFit fit;
  fit.noise = prior.noise;
  for (int iteration = 0; iteration < 8; ++iteration) {
    SurfaceRows::Equations equations = rows.equations();
    equations.matrix.diagonal() += fit.noise * fit.noise * prior.precision;
    const Eigen::FullPivLU<Eigen::Matrix4d> lu(equations.matrix);
    if (!lu.isInvertible()) return std::nullopt;
    fit.normal = equations.matrix;
    fit.inverse = lu.inverse();
    fit.solution = fit.inverse * equations.right;
    fit.noise = std::max(rows.residualsFrom(fit.solution), kLeastNoise);
    rows.weigh(fit.noise);
  }
  return fit;
}

}  // namespace tank_datum
