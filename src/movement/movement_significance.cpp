#include "movement/movement_significance.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/window_means.h"

namespace tank_datum {
namespace {

constexpr double kWidths[] = {0.0,          3 * kDegree,  6 * kDegree,
                              12 * kDegree, 24 * kDegree, 48 * kDegree};  ///< whole [rad]

/// The windows of one width against what they are in draws of an unmoved tank.
class Scale {
 public:
  /// @param draws  one row of dz per draw
  Scale(const std::vector<MatchedStation>& stations, const std::vector<bool>& moved, double width,
        const std::vector<float>& draws)
      : means_(windowsOver(directionsOf(stations), width), weightsOf(stations, moved)), sigmas_(stations.size(), 0.0) {
    const std::size_t n = stations.size();
    drawn_.resize(draws.size());
    for (std::size_t at = 0; at < draws.size(); at += n) {
      means_.of(&draws[at], &drawn_[at]);
      for (std::size_t w = 0; w < n; ++w) sigmas_[w] += drawn_[at + w] * drawn_[at + w];
    }
    for (double& sigma : sigmas_) sigma = std::sqrt(sigma * static_cast<double>(n) / static_cast<double>(draws.size()));
  }

  /// Raises each draw's largest standardised mean to that of these windows.
  void raise(std::vector<double>& maxima) const {
    const std::size_t n = sigmas_.size();
    for (std::size_t draw = 0; draw < maxima.size(); ++draw) {
      for (std::size_t w = 0; w < n; ++w) {
        maxima[draw] = std::max(maxima[draw], std::abs(drawn_[draw * n + w]) / sigmas_[w]);
      }
    }
  }

  /// Whether the window about each station has moved.
  std::vector<bool> beyond(double threshold, const std::vector<float>& dz) {
    std::vector<float> means(sigmas_.size());
    means_.of(dz.data(), means.data());
    std::vector<bool> moved;
    for (std::size_t w = 0; w < means.size(); ++w) moved.push_back(std::abs(means[w]) > threshold * sigmas_[w]);
    return moved;
  }

 private:
  static std::vector<double> directionsOf(const std::vector<MatchedStation>& stations) {
    std::vector<double> directions;
    for (const MatchedStation& m : stations) directions.push_back(m.direction);
    return directions;
  }

  static std::vector<double> weightsOf(const std::vector<MatchedStation>& stations, const std::vector<bool>& moved) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      weights.push_back(moved[i] ? 0.0 : 1.0 / (stations[i].sigma * stations[i].sigma));
    }
    return weights;
  }

  WindowMeans means_;
  std::vector<double> sigmas_;
  std::vector<float> drawn_;  ///< means, one row per draw
};

/// Whether stations on either side, within the window, have moved.
bool isFlanked(const std::vector<MatchedStation>& stations, const std::vector<bool>& moved, std::size_t at,
               double width) {
  bool before = false, after = false;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double off = std::remainder(stations[i].direction - stations[at].direction, kTwoPi);
    if (!moved[i] || std::abs(off) > 0.5 * width) continue;
    before = before || off < 0.0, after = after || off > 0.0;
  }
  return before && after;
}

}  // namespace

LargestRest largestRest(const std::vector<MatchedStation>& stations, const std::vector<double>& drawn, double turn) {
  const std::vector<double> sigmas = sigmasOf(stations, turn);
  LargestRest largest;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (std::abs(stations[i].dz) > std::abs(stations[largest.station].dz)) largest.station = i;
  }
  largest.dz = stations[largest.station].dz, largest.sigma = sigmas[largest.station];
  largest.threshold = quantile(drawn, 1.0 - kAlarmsPerTest);
  largest.moved = largestOf(Steadied(stations).of(dzOf(stations)), sigmas) > largest.threshold;
  return largest;
}

Significance findMoved(const std::vector<MatchedStation>& stations, const std::vector<float>& draws,
                       const CommonErrors& common) {
  Significance result;
  result.moved.assign(stations.size(), false);
  std::vector<double> maxima(draws.size() / stations.size(), 0.0);
  std::vector<Scale> scales;
  for (const double width : kWidths) {
    scales.emplace_back(stations, result.moved, width, draws);
    scales.back().raise(maxima);
  }
  result.threshold = quantile(maxima, 1.0 - kAlarmsPerTest);
  const Eigen::VectorXd steadied = Steadied(stations).of(dzOf(stations));
  const std::vector<float> dz(steadied.begin(), steadied.end());
  for (std::size_t k = 0; k < scales.size(); ++k) {
    const std::vector<bool> before = result.moved, whole = scales[k].beyond(result.threshold, dz);
    if (std::find(whole.begin(), whole.end(), true) == whole.end()) continue;
    const std::vector<bool> left = Scale(stations, before, kWidths[k], draws).beyond(result.threshold, dz);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (whole[i] && (left[i] || isFlanked(stations, before, i, kWidths[k]))) result.moved[i] = true;
    }
  }
  for (const double sigma : sigmasOf(stations, common.turn)) {
    result.sigmas.push_back(std::hypot(sigma, std::hypot(common.height, common.rim)));
  }
  return result;
}

}  // namespace tank_datum
