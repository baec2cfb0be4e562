#include "fit/harmonics.h"

#include <Eigen/Dense>

#include "core/portable_math.h"
#include "core/statistics.h"

namespace tank_datum {

Eigen::RowVectorXd harmonicRow(double azimuth, int order) {
  Eigen::RowVectorXd row(2 * order + 1);
  row[0] = 1.0;
  for (int n = 1; n <= order; ++n) {
    const auto [sine, cosine] = portable::sinCos(n * azimuth);
    row[2 * n - 1] = cosine;
    row[2 * n] = sine;
  }
  return row;
}

Eigen::MatrixXd harmonicRows(const Eigen::VectorXd& azimuths, int order) {
  Eigen::MatrixXd rows(azimuths.size(), 2 * order + 1);
  for (Eigen::Index i = 0; i < azimuths.size(); ++i) rows.row(i) = harmonicRow(azimuths[i], order);
  return rows;
}

double PeriodicFit::operator()(double azimuth) const {
  if (coefficients.size() == 0) return 0.0;
  const auto [sine, cosine] = portable::sinCos(azimuth);
  double value = coefficients[0], c = 1.0, s = 0.0;  // of n times the azimuth
  for (Eigen::Index n = 1; n < coefficients.size(); n += 2) {
    const double before = c;
    c = c * cosine - s * sine;
    s = s * cosine + before * sine;
    value += coefficients[n] * c + coefficients[n + 1] * s;
  }
  return value;
}

PeriodicFit fitHarmonics(const std::vector<double>& azimuths, const std::vector<double>& values,
                         const std::vector<double>& weights, const HarmonicFit& how) {
  PeriodicFit fit;
  const auto count = static_cast<Eigen::Index>(values.size());
  if (count == 0) return fit;
  const Eigen::MatrixXd design = harmonicRows(Eigen::Map<const Eigen::VectorXd>(azimuths.data(), count), how.order);
  const Eigen::VectorXd given = Eigen::Map<const Eigen::VectorXd>(values.data(), count);
  Eigen::VectorXd base = Eigen::VectorXd::Ones(count);
  if (!weights.empty()) base = Eigen::Map<const Eigen::VectorXd>(weights.data(), count);

  Eigen::VectorXd used = base;
  for (int iteration = 0; iteration < (how.robust ? 30 : 1); ++iteration) {
    Eigen::MatrixXd normal = design.transpose() * used.asDiagonal() * design;
    for (int n = 1; n <= how.order; ++n) {
      const double quiet = how.ridge * used.sum() * square(square(static_cast<double>(n) / how.order));
      normal(2 * n - 1, 2 * n - 1) += quiet;
      normal(2 * n, 2 * n) += quiet;
    }
    const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
    fit.coefficients = solver.solve(design.transpose() * (used.asDiagonal() * given));
    fit.covariance = solver.solve(Eigen::MatrixXd::Identity(2 * how.order + 1, 2 * how.order + 1));
    const Eigen::VectorXd residuals = given - design * fit.coefficients;
    const std::vector<double> list(residuals.data(), residuals.data() + count);
    fit.sigma = robustSigma(list, 0.0);
    if (fit.sigma <= 0.0) break;
    for (Eigen::Index i = 0; i < count; ++i) used[i] = base[i] * tukeyWeight(residuals[i] / fit.sigma);
  }
  return fit;
}

}  // namespace tank_datum
