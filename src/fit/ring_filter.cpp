#include "fit/ring_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"
#include "fit/harmonics.h"

namespace tank_datum {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kPad = 60.0 * kPi / 180.0;  // of the ring that is run through once more at either end

struct State {
  Vector2d mean, predicted_mean;
  Matrix2d cov, predicted_cov;
};

/// The process from one place to the next.
struct Transition {
  Matrix2d phi, noise, stationary;

  Transition(const ProcessParameters& p, double step) {
    const double rate = std::sqrt(3.0) / p.length, decay = portable::exp(-rate * step);
    phi << decay * (1.0 + rate * step), decay * step, -decay * rate * rate * step, decay * (1.0 - rate * step);
    stationary << p.amplitude * p.amplitude, 0.0, 0.0, rate * rate * p.amplitude * p.amplitude;
    noise = stationary - phi * stationary * phi.transpose();
  }
};

std::size_t padOf(const RingData& data) {
  return std::min(data.values.size() / 2, static_cast<std::size_t>(kPad / data.step));
}

std::size_t placeAt(const RingData& data, std::size_t k) {
  return (k + data.values.size() - padOf(data)) % data.values.size();
}

/// Forwards through the padded ring.
/// @return  unlikeliness()
double filter(const RingData& data, const ProcessParameters& p, std::vector<State>* states) {
  constexpr double kFreedom = 30.0;
  const Transition transition(p, data.step);
  const std::size_t count = data.values.size(), pad = padOf(data);
  Vector2d mean = Vector2d::Zero();
  Matrix2d cov = transition.stationary;
  double unlikely = 0;
  for (std::size_t k = 0; k < count + 2 * pad; ++k) {
    if (k > 0) {
      mean = transition.phi * mean;
      cov = transition.phi * cov * transition.phi.transpose() + transition.noise;
    }
    const Vector2d predicted_mean = mean;
    const Matrix2d predicted_cov = cov;
    const std::size_t i = placeAt(data, k);
    if (std::isfinite(data.values[i])) {
      const double variance = cov(0, 0) + p.variance(data.variances[i]);
      const double off = data.values[i] - mean[0];
      const Vector2d gain = cov.col(0) / variance;
      mean += gain * off;
      cov -= gain * cov.row(0);
      if (k >= pad && k < pad + count) {
        unlikely += portable::log(variance) + (kFreedom + 1.0) * portable::log1p(off * off / variance / kFreedom);
      }
    }
    if (states != nullptr) states->push_back({mean, predicted_mean, cov, predicted_cov});
  }
  return unlikely;
}

/// Backwards through what filter() went.
void smoothBack(std::vector<State> states, const RingData& data, const ProcessParameters& p, RingProcess& result) {
  const Transition transition(p, data.step);
  const std::size_t count = data.values.size(), pad = padOf(data);
  for (std::size_t k = states.size() - 1; k-- > 0;) {
    const State& next = states[k + 1];
    State& state = states[k];
    const Matrix2d gain = state.cov * transition.phi.transpose() * next.predicted_cov.inverse();
    state.mean += gain * (next.mean - next.predicted_mean);
    state.cov += gain * (next.cov - next.predicted_cov) * gain.transpose();
  }
  for (std::size_t k = pad; k < pad + count; ++k) {
    const std::size_t i = placeAt(data, k);
    result.value[i] = states[k].mean[0];
    result.sigma[i] = std::sqrt(std::max(0.0, states[k].cov(0, 0)));
  }
}

}  // namespace

double unlikeliness(const RingData& data, const ProcessParameters& p) { return filter(data, p, nullptr); }

void smoothRing(const RingData& data, const ProcessParameters& p, RingProcess& result) {
  std::vector<State> states;
  filter(data, p, &states);
  smoothBack(std::move(states), data, p, result);
}

OffOthers offOthers(const RingData& data, const ProcessParameters& p, const RingProcess& smoothed) {
  OffOthers off{std::vector<double>(data.values.size(), 0.0), std::vector<double>(data.values.size(), 1.0)};
  for (std::size_t i = 0; i < data.values.size(); ++i) {
    if (!std::isfinite(data.values[i])) continue;
    const double own = p.variance(data.variances[i]), all = square(smoothed.sigma[i]);
    const double others = 1.0 / std::max(1.0 / all - 1.0 / own, 1e-9 / own);
    off.distance[i] = data.values[i] - others * (smoothed.value[i] / all - data.values[i] / own);
    off.sigma[i] = std::sqrt(others + own);
  }
  return off;
}

std::vector<double> varianceOfShape(const RingData& data, const ProcessParameters& p, int order) {
  const auto count = static_cast<Eigen::Index>(data.values.size()), pad = static_cast<Eigen::Index>(padOf(data));
  Eigen::MatrixXd left(count, 2 * order + 1), scaled = left;  // of the harmonics; what each value tells of them
  for (Eigen::Index i = 0; i < count; ++i) left.row(i) = harmonicRow(static_cast<double>(i) * data.step, order);
  scaled.setZero();
  for (Eigen::Index term = 0; term < left.cols(); ++term) {
    RingData column = data;
    RingProcess followed;
    followed.value.resize(data.values.size()), followed.sigma = followed.value;
    for (std::size_t i = 0; i < data.values.size(); ++i)
      if (std::isfinite(data.values[i])) column.values[i] = left(static_cast<Eigen::Index>(i), term);
    std::vector<State> states;
    filter(column, p, &states);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const State& state = states[static_cast<std::size_t>(i + pad)];
      if (!std::isfinite(column.values[place])) continue;
      const double variance = state.predicted_cov(0, 0) + p.variance(data.variances[place]);
      scaled(i, term) = (column.values[place] - state.predicted_mean[0]) / std::sqrt(variance);
    }
    smoothBack(std::move(states), column, p, followed);
    left.col(term) -= Eigen::Map<const Eigen::VectorXd>(followed.value.data(), count);
  }
  constexpr double kHighest = 1.0;  // of a wave of a foundation, as where fewer values are known than waves [m]
  const Eigen::MatrixXd any = Eigen::MatrixXd::Identity(left.cols(), left.cols()) / square(kHighest);
  const Eigen::MatrixXd known = any + scaled.transpose() * scaled;
  const Eigen::MatrixXd rest = known.ldlt().solve(left.transpose());
  std::vector<double> variances;
  for (Eigen::Index i = 0; i < count; ++i) variances.push_back(std::max(0.0, left.row(i).dot(rest.col(i))));
  return variances;
}

}  // namespace tank_datum
