#include "fit/circle_process.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The values that are known, and where.
struct Known {
  std::vector<Index> at;
  VectorXd values, sigmas, alike;

  explicit Known(const std::vector<NoisyValue>& series) {
    for (std::size_t i = 0; i < series.size(); ++i) {
      if (std::isfinite(series[i].value + series[i].sigma + series[i].alike)) at.push_back(static_cast<Index>(i));
    }
    const auto pick = [&](double NoisyValue::*what) {
      VectorXd picked(static_cast<Index>(at.size()));
      for (std::size_t k = 0; k < at.size(); ++k)
        picked[static_cast<Index>(k)] = series[static_cast<std::size_t>(at[k])].*what;
      return picked;
    };
    values = pick(&NoisyValue::value), sigmas = pick(&NoisyValue::sigma), alike = pick(&NoisyValue::alike);
  }
};

/// How alike a process is at each two of so many steps.
MatrixXd alikeOver(Index steps, double length) {
  VectorXd apart(steps);
  for (Index i = 0; i < steps; ++i) {
    const double chord = 2.0 * portable::sin(kPi * static_cast<double>(i) / static_cast<double>(steps));
    const double lengths = std::sqrt(3.0) * chord / length;
    apart[i] = (1.0 + lengths) * portable::exp(-lengths);
  }
  MatrixXd alike(steps, steps);
  for (Index i = 0; i < steps; ++i) {
    for (Index j = 0; j < steps; ++j) alike(i, j) = apart[std::abs(i - j)];
  }
  return alike;
}

/// What the values follow under one amplitude and length.
struct Followed {
  VectorXd mean, variance;
  double unlikely;     ///< minus twice the logarithm of the values' density, but for a constant
  double share = 1.0;  ///< of the processes that may be, before the values are seen
};

/// @param round  covariance of the process at each two steps
/// @param noise  of the values
Followed followUnder(const MatrixXd& round, const MatrixXd& noise, const Known& known) {
  const Eigen::LLT<MatrixXd> root(round(known.at, known.at) + noise);
  const VectorXd white = root.matrixL().solve(known.values);
  const MatrixXd told = root.matrixL().solve(MatrixXd(round(known.at, Eigen::all)));
  double unlikely = white.squaredNorm();
  for (Index k = 0; k < white.size(); ++k) unlikely += 2.0 * portable::log(root.matrixLLT()(k, k));
  return {told.transpose() * white, round.diagonal() - told.colwise().squaredNorm().transpose(), unlikely};
}

/// Of all of them together, each by how likely the values are under it.
std::vector<ProcessValue> averageOf(const std::vector<Followed>& all) {
  double least = all.front().unlikely, sum = 0;
  for (const Followed& one : all) least = std::min(least, one.unlikely);
  VectorXd mean = VectorXd::Zero(all.front().mean.size()), squares = mean;
  for (const Followed& one : all) {
    const double weight = one.share * portable::exp(0.5 * (least - one.unlikely));
    sum += weight;
    mean += weight * one.mean;
    squares += weight * (one.variance + one.mean.cwiseAbs2());
  }
  std::vector<ProcessValue> average;
  for (Index i = 0; i < mean.size(); ++i) {
    const double value = mean[i] / sum;
    average.push_back({value, std::sqrt(std::max(0.0, squares[i] / sum - value * value))});
  }
  return average;
}

}  // namespace

std::vector<ProcessValue> followCircle(const std::vector<NoisyValue>& series, double common, double usual) {
  constexpr double kAlike = 1.0;                                              // [rad]
  constexpr std::array kLengths{0.04, 0.1, 0.2, 0.4, 0.8, 1.6};               // [rad]
  constexpr std::array kAmplitudes{4.0, 2.0, 1.0, 0.5, 0.25, 0.125, 0.0625};  // of the usual one
  constexpr std::array kCommon{0.0, 0.5, 1.0};
  const Known known(series);
  const auto steps = static_cast<Index>(series.size());
  if (known.at.empty()) return std::vector<ProcessValue>(series.size(), {0.0, usual});
  MatrixXd alike = alikeOver(steps, kAlike)(known.at, known.at);
  alike.array() *= (known.alike * known.alike.transpose()).array();
  std::vector<MatrixXd> noises;
  std::vector<Followed> all;
  for (const double part : kCommon) {
    noises.push_back(alike);
    noises.back().diagonal() += (known.sigmas.cwiseAbs2().array() + square(part * common)).matrix();
    all.push_back(followUnder(MatrixXd::Zero(steps, steps), noises.back(), known));
    all.back().share = static_cast<double>(kLengths.size());  // as of each amplitude
  }
  for (const double length : kLengths) {
    const MatrixXd round = alikeOver(steps, length);
    for (const double amplitude : kAmplitudes) {
      for (const MatrixXd& noise : noises) {
        all.push_back(followUnder(square(amplitude * usual) * round, noise, known));
        all.back().share = 1.0 / square(std::max(1.0, amplitude));
      }
    }
  }
  return averageOf(all);
}

}  // namespace tank_datum
