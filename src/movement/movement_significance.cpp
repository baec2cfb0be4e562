#include "movement/movement_significance.h"

#include <algorithm>
#include <cmath>

#include "core/deviates.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "fit/window_means.h"

namespace tank_datum {
namespace {

constexpr std::size_t kDraws = 2000;
/// Aimed at, so that at most 5 % are left where errors reach somewhat beyond the windows that surveys give for them.
constexpr double kFalseAlarms = 0.03;
constexpr double kWidths[] = {0.0,          3 * kDegree,  6 * kDegree,
                              12 * kDegree, 24 * kDegree, 48 * kDegree};  ///< whole [rad]

/// Leaves no station by itself (a Hampel filter): one that is further from the median of the stations within 2 degrees
/// than kOutlier of its sigmas is put there. A shell carries no step over one degree, but scans have single stations
/// seven sigmas off. Stations with fewer than four such neighbours stay as they are.
class Steadied {
 public:
  explicit Steadied(const std::vector<MatchedStation>& stations) {
    constexpr double kNear = 2.0 * kPi / 180.0 + 1e-6;
    const std::size_t n = stations.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto near = [&](std::size_t j) {
        return std::abs(std::remainder(stations[j].direction - stations[i].direction, kTwoPi)) <= kNear;
      };
      std::vector<std::size_t> beside = {i};
      for (std::size_t k = 1; k < n && near((i + k) % n); ++k) beside.push_back((i + k) % n);
      for (std::size_t k = 1; k < n && near((i + n - k) % n); ++k) beside.push_back((i + n - k) % n);
      if (beside.size() < 5) beside.clear();
      beside_.push_back(std::move(beside));
      reach_.push_back(kOutlier * stations[i].own());
    }
  }

  /// The stations with their dz so treated.
  const std::vector<MatchedStation>& of(const std::vector<MatchedStation>& stations) {
    steadied_ = stations;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const double reach = reach_[i];
      std::size_t far = 0;  // the median is no further off than half of the stations are
      for (const std::size_t j : beside_[i]) far += std::abs(stations[j].dz - stations[i].dz) > reach ? 1 : 0;
      if (2 * far < beside_[i].size() || beside_[i].empty()) continue;
      around_.clear();
      for (const std::size_t j : beside_[i]) around_.push_back(stations[j].dz);
      const auto middle = around_.begin() + static_cast<std::ptrdiff_t>(around_.size() / 2);
      std::nth_element(around_.begin(), middle, around_.end());
      if (std::abs(stations[i].dz - *middle) > reach) steadied_[i].dz = *middle;
    }
    return steadied_;
  }

 private:
  static constexpr double kOutlier = 2.5;
  std::vector<std::vector<std::size_t>> beside_;
  std::vector<double> reach_;  ///< of a station's own, kOutlier of its sigmas [m]
  std::vector<MatchedStation> steadied_;
  std::vector<double> around_;
};

/// Comparisons of an unmoved tank. A station's own error is the mean of white noise along its window, so that stations
/// share errors as far as they share points; to it come the errors that the surveys say their stations share.
class Unmoved {
 public:
  Unmoved(const std::vector<MatchedStation>& stations, const CommonErrors& common, const MovementOptions& options)
      : stations_(stations), common_(common), part_(stations, options.removal, true) {
    cells_ = std::max<std::size_t>(360, stations.size());
    const double cell = kTwoPi / static_cast<double>(cells_);
    for (const MatchedStation& m : stations) {
      const double window = options.correlation > 0.0 ? options.correlation : m.window;
      const double most = 0.5 * static_cast<double>(cells_);
      const auto width = static_cast<std::size_t>(std::clamp(std::ceil(window / cell - 1e-6), 1.0, most));
      const double start = std::round(m.direction / cell - 0.5 * static_cast<double>(width));
      const auto first = static_cast<std::size_t>(start < 0.0 ? start + static_cast<double>(cells_) : start);
      own_.push_back(m.own());
      towards_.emplace_back(portable::cos(m.direction), portable::sin(m.direction));
      shares_.push_back({first % cells_, width, 1.0 / std::sqrt(static_cast<double>(width))});
    }
  }

  /// The stations with errors alone for dz.
  const std::vector<MatchedStation>& draw() {
    std::vector<double> sums(2 * cells_ + 1, 0.0);
    for (std::size_t i = 0; i < cells_; ++i) sums[i + 1] = sums[i] + normal_();
    for (std::size_t i = 0; i < cells_; ++i) sums[cells_ + i + 1] = sums[cells_] + sums[i + 1];
    Eigen::VectorXd common(stations_.front().shared.size());
    for (double& error : common) error = normal_();
    const double turn = common_.turn * normal_(), width = studentWidth(normal_, common_.freedom);
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Share& s = shares_[i];
      const double error = (sums[s.first + s.width] - sums[s.first]) * s.scale;
      stations_[i].dz = own_[i] * width * error + stations_[i].shared.dot(common) + stations_[i].slope * turn;
    }
    part_.removeFrom(stations_);
    const double height = common_.height * normal_(), east = common_.rim * normal_(), north = common_.rim * normal_();
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      stations_[i].dz += height + east * towards_[i].x() + north * towards_[i].y();
    }
    return stations_;
  }

 private:
  struct Share {
    std::size_t first, width;
    double scale;
  };
  std::vector<MatchedStation> stations_;
  CommonErrors common_;
  CommonPart part_;
  std::size_t cells_ = 0;
  std::vector<Share> shares_;
  std::vector<double> own_;               ///< standard errors of the stations' own [m]
  std::vector<Eigen::Vector2d> towards_;  ///< the stations from the axis, of length 1
  Deviates normal_{20180419};
};

std::vector<float> dzOf(const std::vector<MatchedStation>& stations) {
  std::vector<float> dz;
  for (const MatchedStation& m : stations) dz.push_back(static_cast<float>(m.dz));
  return dz;
}

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

/// The largest dz in its standard errors.
double largestOf(const std::vector<MatchedStation>& stations, const std::vector<double>& sigmas) {
  double largest = 0.0;
  for (std::size_t i = 0; i < stations.size(); ++i) largest = std::max(largest, std::abs(stations[i].dz) / sigmas[i]);
  return largest;
}

}  // namespace

LargestRest largestRest(const std::vector<MatchedStation>& stations, const CommonErrors& common,
                        MovementOptions options) {
  options.removal = Removal::Tilt;
  Unmoved unmoved(stations, {0.0, 0.0, common.turn, common.freedom}, options);
  Steadied steadied(stations);
  LargestRest largest;
  std::vector<double> sigmas, maxima;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    sigmas.push_back(std::hypot(stations[i].sigma, stations[i].slope * common.turn));
    if (std::abs(stations[i].dz) > std::abs(stations[largest.station].dz)) largest.station = i;
  }
  largest.dz = stations[largest.station].dz, largest.sigma = sigmas[largest.station];
  for (std::size_t draw = 0; draw < kDraws; ++draw) maxima.push_back(largestOf(steadied.of(unmoved.draw()), sigmas));
  largest.threshold = quantile(maxima, 1.0 - kFalseAlarms);
  largest.moved = largestOf(steadied.of(stations), sigmas) > largest.threshold;
  return largest;
}

Significance findMoved(const std::vector<MatchedStation>& stations, const CommonErrors& common,
                       const MovementOptions& options) {
  Unmoved unmoved(stations, common, options);
  Steadied steadied(stations);
  std::vector<float> draws;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    const std::vector<float> dz = dzOf(steadied.of(unmoved.draw()));
    draws.insert(draws.end(), dz.begin(), dz.end());
  }
  Significance result;
  result.moved.assign(stations.size(), false);
  std::vector<double> maxima(kDraws, 0.0);
  std::vector<Scale> scales;
  for (const double width : kWidths) {
    scales.emplace_back(stations, result.moved, width, draws);
    scales.back().raise(maxima);
  }
  result.threshold = quantile(maxima, 1.0 - kFalseAlarms);
  const std::vector<float> dz = dzOf(steadied.of(stations));
  for (std::size_t k = 0; k < scales.size(); ++k) {
    const std::vector<bool> before = result.moved, whole = scales[k].beyond(result.threshold, dz);
    if (std::find(whole.begin(), whole.end(), true) == whole.end()) continue;
    const std::vector<bool> left = Scale(stations, before, kWidths[k], draws).beyond(result.threshold, dz);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (whole[i] && (left[i] || isFlanked(stations, before, i, kWidths[k]))) result.moved[i] = true;
    }
  }
  for (const MatchedStation& m : stations) {
    const double own = std::hypot(m.sigma, m.slope * common.turn);
    result.sigmas.push_back(std::hypot(own, std::hypot(common.height, common.rim)));
  }
  return result;
}

}  // namespace tank_datum
