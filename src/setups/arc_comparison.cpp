#include "setups/arc_comparison.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/statistics.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestOfSetup = 12;  // points of a setup that make its offset worth looking at
constexpr std::size_t kFewestOfBin = 6;     // points of a bin that tell its scatter
constexpr std::size_t kFewestOfPart = 3;    // points of one setup in one bin that make a first median
constexpr Eigen::Index kOfPart = 3;         // unknowns of a part's curve

/// The points of the bins that two setups or more have, by bin.
struct Bin {
  std::vector<ArcPoint> points;  // setup: the index among those of the arc
  double height = 0.0;           // of the surface [m]
  double noise = 0.0;            // of the points about it [m]
};

struct Arc {
  std::vector<std::size_t> setups;
  std::vector<Bin> bins;
  Eigen::VectorXd offsets;
  Eigen::VectorXd curves;  // of each part its slope, its bend, and what it lies off the others

  double residual(const Bin& bin, const ArcPoint& p) const {
    const auto curve = curves.segment<kOfPart>(kOfPart * p.part);
    return p.value - bin.height - offsets[p.setup] - (curve[0] + curve[1] * p.t) * p.t - curve[2];
  }
};

std::size_t setupsIn(const std::vector<ArcPoint>& points) {
  std::vector<std::uint16_t> seen;
  for (const ArcPoint& p : points) {
    if (std::find(seen.begin(), seen.end(), p.setup) == seen.end()) seen.push_back(p.setup);
  }
  return seen.size();
}

/// Leaves out what lies off a bin's densest place, bins that one setup has to itself, and setups with few points.
Arc sorted(const std::vector<ArcPoint>& points, double window) {
  std::map<std::uint16_t, Bin> bins;
  for (const ArcPoint& p : points) bins[p.bin].points.push_back(p);
  std::map<std::uint16_t, std::size_t> counts;
  for (auto at = bins.begin(); at != bins.end();) {
    std::vector<ArcPoint>& own = at->second.points;
    std::vector<double> values;
    for (const ArcPoint& p : own) values.push_back(p.value);
    std::sort(values.begin(), values.end());
    const double mode = halfSampleMode(values);
    own.erase(
        std::remove_if(own.begin(), own.end(), [&](const ArcPoint& p) { return std::abs(p.value - mode) > window; }),
        own.end());
    const bool shared = own.size() >= kFewestOfBin && setupsIn(own) > 1;
    if (shared) {
      for (const ArcPoint& p : own) ++counts[p.setup];
    }
    at = shared ? std::next(at) : bins.erase(at);
  }
  Arc arc;
  std::map<std::uint16_t, std::uint16_t> index;
  for (const auto& [setup, count] : counts) {
    if (count < kFewestOfSetup) continue;
    index[setup] = static_cast<std::uint16_t>(arc.setups.size());
    arc.setups.push_back(setup);
  }
  for (auto& [number, bin] : bins) {
    Bin kept;
    for (ArcPoint p : bin.points) {
      const auto found = index.find(p.setup);
      if (found == index.end()) continue;
      p.setup = found->second;
      kept.points.push_back(p);
    }
    if (setupsIn(kept.points) > 1) arc.bins.push_back(std::move(kept));
  }
  return arc;
}

/// First offsets: medians of the differences between the setups' medians, bin by bin and part by part, from the setup
/// that most of them have.
void guessOffsets(Arc& arc, std::size_t parts) {
  const std::size_t count = arc.setups.size(), fewest = parts > 1 ? 1 : kFewestOfPart;
  std::vector<std::vector<double>> medians(arc.bins.size() * parts, std::vector<double>(count, std::nan("")));
  std::vector<std::size_t> has(count, 0);
  for (std::size_t b = 0; b < arc.bins.size(); ++b) {
    std::vector<std::vector<double>> values(count * parts);
    for (const ArcPoint& p : arc.bins[b].points) values[p.part * count + p.setup].push_back(p.value);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].size() < fewest) continue;
      medians[b * parts + i / count][i % count] = median(values[i]);
      ++has[i % count];
    }
  }
  const auto first = static_cast<std::size_t>(std::max_element(has.begin(), has.end()) - has.begin());
  arc.offsets = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  for (std::size_t s = 0; s < count; ++s) {
    std::vector<double> differences;
    for (const auto& row : medians) {
      if (std::isfinite(row[s] - row[first])) differences.push_back(row[s] - row[first]);
    }
    if (!differences.empty()) arc.offsets[static_cast<Eigen::Index>(s)] = median(differences);
  }
}

/// First heights of the bins, and what each of several parts lies off the others: medians of what is left.
void guessSurface(Arc& arc, std::size_t parts) {
  const auto setMedians = [&arc] {
    for (Bin& bin : arc.bins) {
      std::vector<double> left;
      for (const ArcPoint& p : bin.points) left.push_back(arc.residual(bin, p));
      bin.height += median(left);
    }
  };
  setMedians();
  if (parts == 1) return;
  std::vector<std::vector<double>> left(parts);
  for (const Bin& bin : arc.bins) {
    for (const ArcPoint& p : bin.points) left[p.part].push_back(arc.residual(bin, p));
  }
  for (std::size_t k = 0; k < parts; ++k) {
    if (!left[k].empty()) arc.curves[kOfPart * static_cast<Eigen::Index>(k) + 2] = median(left[k]);
  }
  setMedians();
}

/// Scatter of every bin about its height; that of all stands in for a few points.
void findNoise(Arc& arc) {
  constexpr double kPooled = 10.0;
  std::vector<double> all;
  for (Bin& bin : arc.bins) {
    std::vector<double> residuals;
    for (const ArcPoint& p : bin.points) residuals.push_back(arc.residual(bin, p));
    bin.noise = robustSigma(residuals, 0.0);
    all.push_back(bin.noise);
  }
  const double pooled = median(all);
  for (Bin& bin : arc.bins) {
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
Equations equationsOf(const Arc& arc, const Bin& bin) {
  const auto count = static_cast<Eigen::Index>(arc.setups.size()), size = count + arc.curves.size();
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd products = Eigen::VectorXd::Zero(size), mean = Eigen::VectorXd::Zero(size);
  double weights = 0.0, mean_value = 0.0;
  for (const ArcPoint& p : bin.points) {
    const double w = tukeyWeight(arc.residual(bin, p) / bin.noise) / (bin.noise * bin.noise);
    if (w == 0.0) continue;
    const Eigen::Index curve = count + kOfPart * p.part;
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

Equations equationsOf(const Arc& arc, const ArcPrior& prior) {
  const auto count = static_cast<Eigen::Index>(arc.setups.size()), size = count + arc.curves.size();
  Equations sum{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (const Bin& bin : arc.bins) {
    const Equations own = equationsOf(arc, bin);
    if (own.matrix.size() == 0) continue;
    sum.matrix += own.matrix;
    sum.right += own.right;
  }
  const std::array<double, kOfPart> sigmas{prior.sigma_along, prior.sigma_bend, prior.sigma_part};
  for (Eigen::Index i = 0; i < arc.curves.size(); ++i) {
    const double sigma = sigmas[static_cast<std::size_t>(i % kOfPart)];
    sum.matrix(count + i, count + i) += 1.0 / (sigma * sigma);
  }
  return sum;
}

/// Weighted mean of what is left in each bin becomes its height.
void setHeights(Arc& arc) {
  for (Bin& bin : arc.bins) {
    double weights = 0.0, sum = 0.0;
    for (const ArcPoint& p : bin.points) {
      const double left = arc.residual(bin, p), w = tukeyWeight(left / bin.noise);
      weights += w;
      sum += w * left;
    }
    if (weights > 0.0) bin.height += sum / weights;
  }
}

}  // namespace

std::optional<ArcOffsets> compareArc(const std::vector<ArcPoint>& points, const ArcPrior& prior) {
  constexpr int kIterations = 6;
  Arc arc = sorted(points, prior.window);
  const auto count = static_cast<Eigen::Index>(arc.setups.size());
  if (count < 2 || arc.bins.empty()) return std::nullopt;
  const Eigen::Index shape = kOfPart * static_cast<Eigen::Index>(prior.parts);
  arc.curves = Eigen::VectorXd::Zero(shape);
  guessOffsets(arc, prior.parts);
  guessSurface(arc, prior.parts);
  ArcOffsets result;
  result.setups = arc.setups;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    findNoise(arc);
    const Equations sum = equationsOf(arc, prior);
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
  }
  return result;
}

}  // namespace tank_datum
