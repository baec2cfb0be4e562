#include "setups/arc_comparison.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/statistics.h"
#include "setups/arc_surface.h"

namespace tank_datum {
namespace {

/// Scatter of every bin about its height; that of all stands in for a few points.
void findNoise(ArcSurface& arc) {
  constexpr double kPooled = 10.0;
  std::vector<double> all;
  for (ArcBin& bin : arc.bins) {
    std::vector<double> residuals;
    for (const ArcPoint& p : bin.points) residuals.push_back(arc.residual(bin, p));
    bin.noise = robustSigma(residuals, 0.0);
    all.push_back(bin.noise);
  }
  const double pooled = median(all);
  for (ArcBin& bin : arc.bins) {
    const auto n = static_cast<double>(bin.points.size());
    bin.noise = std::max(std::sqrt((kPooled * pooled * pooled + n * bin.noise * bin.noise) / (kPooled + n)), 1e-7);
  }
}

/// Normal equations of offsets and of the parts' curves, the bins' heights eliminated.
struct Equations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

/// Those of one bin, its own height eliminated; nothing where no point counts.
Equations equationsOf(const ArcSurface& arc, const ArcBin& bin) {
  const auto count = static_cast<Eigen::Index>(arc.setups.size()), size = count + arc.curves.size();
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd products = Eigen::VectorXd::Zero(size), mean = Eigen::VectorXd::Zero(size);
  double weights = 0.0, mean_value = 0.0;
  for (const ArcPoint& p : bin.points) {
    const double w = tukeyWeight(arc.residual(bin, p) / bin.noise) / (bin.noise * bin.noise);
    if (w == 0.0) continue;
    const Eigen::Index curve = count + ArcSurface::kOfPart * p.part;
    const std::array<Eigen::Index, 4> at{p.setup, curve, curve + 1, curve + 2};  // entries of its row that are not zero
    const std::array<double, 4> row{1.0, p.t, p.t * p.t, 1.0};
    const double v = p.value - bin.height;
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (std::size_t j = i; j < row.size(); ++j) squares(at[i], at[j]) += w * row[i] * row[j];
      products[at[i]] += w * row[i] * v;
      mean[at[i]] += w * row[i];
    }
    mean_value += w * v;
    weights += w;
  }
  if (!(weights > 0.0)) return {};
  squares.triangularView<Eigen::StrictlyLower>() = squares.transpose();
  return {squares - mean * mean.transpose() / weights, products - mean * (mean_value / weights)};
}

/// Inverse variances of the priors on the parts' curves.
Eigen::VectorXd informationOf(const ArcPrior& prior) {
  const Eigen::Array3d sigmas(prior.sigma_along, prior.sigma_bend, prior.sigma_part);
  return sigmas.square().inverse().matrix().replicate(static_cast<Eigen::Index>(prior.parts), 1);
}

/// @param known  information of the priors on the parts' curves
Equations equationsOf(const ArcSurface& arc, const Eigen::VectorXd& known) {
  const auto count = static_cast<Eigen::Index>(arc.setups.size()), size = count + arc.curves.size();
  Equations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (const ArcBin& bin : arc.bins) {
    const Equations own = equationsOf(arc, bin);
    if (own.matrix.size() == 0) continue;
    sum.matrix += own.matrix;
    sum.right += own.right;
  }
  sum.matrix.diagonal().tail(arc.curves.size()) += known;
  return sum;
}

/// Weighted mean of what is left in each bin becomes its height.
void setHeights(ArcSurface& arc) {
  for (ArcBin& bin : arc.bins) {
    double weights = 0.0, sum = 0.0;
    for (const ArcPoint& p : bin.points) {
      const double left = arc.residual(bin, p), w = tukeyWeight(left / bin.noise);
      weights += w;
      sum += w * left;
    }
    if (weights > 0.0) bin.height += sum / weights;
  }
}

/// The share of the points that is left beside what they determine: by its root their scatter is larger than it looks.
double freedomLeft(const ArcSurface& arc, double unknowns) {
  double points = 0.0;
  for (const ArcBin& bin : arc.bins) points += static_cast<double>(bin.points.size());
  return 1.0 - (unknowns + static_cast<double>(arc.bins.size())) / points;
}

}  // namespace

std::optional<ArcOffsets> compareArc(const std::vector<ArcPoint>& points, const ArcPrior& prior) {
  constexpr int kIterations = 6;
  constexpr double kLeastFreedom = 0.5;  // where most points are fitted exactly their scatter says nothing
  ArcSurface arc = guessedSurface(points, prior);
  const auto count = static_cast<Eigen::Index>(arc.setups.size());
  if (count < 2 || arc.bins.empty()) return std::nullopt;
  const Eigen::VectorXd known = informationOf(prior);
  const Eigen::Index shape = known.size();
  ArcOffsets result;
  result.setups = arc.setups;
  double unknowns = 0.0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    findNoise(arc);
    const Equations sum = equationsOf(arc, known);
    const Eigen::MatrixXd inverse = sum.matrix.bottomRightCorner(shape, shape).inverse();
    const Eigen::MatrixXd across = sum.matrix.topRightCorner(count, shape) * inverse;
    result.information = sum.matrix.topLeftCorner(count, count) - across * sum.matrix.bottomLeftCorner(shape, count);
    const Eigen::VectorXd right = sum.right.head(count) - across * sum.right.tail(shape);
    // the sum of the offsets is nowhere in the data: any weight on it sets it to zero
    const double gauge = result.information.trace() / static_cast<double>(count * count);
    if (!(gauge > 0.0)) return std::nullopt;
    const Eigen::MatrixXd fixed = result.information + Eigen::MatrixXd::Constant(count, count, gauge);
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(fixed);
    if (!lu.isInvertible()) return std::nullopt;
    result.offsets = lu.solve(right);
    result.offsets.array() -= result.offsets.mean();
    arc.curves = inverse * (sum.right.tail(shape) - sum.matrix.bottomLeftCorner(shape, count) * result.offsets);
    arc.offsets = result.offsets;
    setHeights(arc);
    unknowns = static_cast<double>(count - 1 + shape) - known.dot(inverse.diagonal());
  }
  const double freedom = freedomLeft(arc, unknowns);
  if (freedom < kLeastFreedom) return std::nullopt;
  result.information *= freedom;
  return result;
}

}  // namespace tank_datum
