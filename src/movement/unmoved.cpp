#include "movement/unmoved.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/deviates.h"
#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kOutlier = 2.5;  // sigmas
constexpr std::size_t kDraws = 2000;

/// Comparisons of an unmoved tank. A station's own error is the mean of white noise along its window, so that stations
/// share errors as far as they share points; to it come the errors that the surveys say their stations share.
class Unmoved {
 public:
  /// @param stations     before anything is removed
  /// @param correlation  arc within which stations share points; 0: their windows [rad]
  Unmoved(const std::vector<MatchedStation>& stations, const CommonErrors& common, double correlation);

  /// Draws the stations' dz of errors alone [m].
  Eigen::VectorXd draw();
  /// The height and the tilt that the registration leaves, as they were drawn with them, at each station [m].
  Eigen::VectorXd registration() const;

 private:
  struct Share {
    std::size_t first, width;
    double scale;
  };
  const std::vector<MatchedStation>& stations_;
  CommonErrors common_;
  std::size_t cells_ = 0;
  std::vector<Share> shares_;
  std::vector<double> own_;               ///< standard errors of the stations' own [m]
  std::vector<Eigen::Vector2d> towards_;  ///< the stations from the axis, of length 1
  double height_ = 0.0;                   ///< drawn [m]
  Eigen::Vector2d rim_{0.0, 0.0};         ///< drawn [m]
  Deviates normal_{20180419};
};

Unmoved::Unmoved(const std::vector<MatchedStation>& stations, const CommonErrors& common, double correlation)
    : stations_(stations), common_(common) {
  cells_ = std::max<std::size_t>(360, stations.size());
  const double cell = kTwoPi / static_cast<double>(cells_);
  constexpr double kRounding = 1e-6;  // of a cell: azimuths are as rounded as the file they come from
  for (const MatchedStation& m : stations) {
    const double window = correlation > 0.0 ? correlation : m.window;
    const double most = 0.5 * static_cast<double>(cells_);
    const auto width = static_cast<std::size_t>(std::clamp(std::ceil(window / cell - kRounding), 1.0, most));
    const double start = std::round(m.direction / cell - 0.5 * static_cast<double>(width) - kRounding);
    const auto first = static_cast<std::size_t>(start < 0.0 ? start + static_cast<double>(cells_) : start);
    own_.push_back(m.own());
    towards_.emplace_back(portable::cos(m.direction), portable::sin(m.direction));
    shares_.push_back({first % cells_, width, 1.0 / std::sqrt(static_cast<double>(width))});
  }
}

Eigen::VectorXd Unmoved::draw() {
  std::vector<double> sums(2 * cells_ + 1, 0.0);
  for (std::size_t i = 0; i < cells_; ++i) sums[i + 1] = sums[i] + normal_();
  for (std::size_t i = 0; i < cells_; ++i) sums[cells_ + i + 1] = sums[cells_] + sums[i + 1];
  Eigen::VectorXd common(stations_.front().shared.size());
  for (double& error : common) error = normal_();
  const double turn = common_.turn * normal_(), width = studentWidth(normal_, common_.freedom);
  Eigen::VectorXd dz(static_cast<Eigen::Index>(stations_.size()));
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const Share& s = shares_[i];
    const double error = (sums[s.first + s.width] - sums[s.first]) * s.scale;
    dz[static_cast<Eigen::Index>(i)] =
        own_[i] * width * error + stations_[i].shared.dot(common) + stations_[i].slope * turn;
  }
  height_ = common_.height * normal_();
  rim_.x() = common_.rim * normal_(), rim_.y() = common_.rim * normal_();
  return dz;
}

Eigen::VectorXd Unmoved::registration() const {
  Eigen::VectorXd heights(static_cast<Eigen::Index>(towards_.size()));
  for (Eigen::Index i = 0; i < heights.size(); ++i)
    heights[i] = height_ + rim_.dot(towards_[static_cast<std::size_t>(i)]);
  return heights;
}

}  // namespace

Steadied::Steadied(const std::vector<MatchedStation>& stations) {
  constexpr double kNear = 2.0 * kPi / 180.0 + 1e-6;
  const auto n = static_cast<Eigen::Index>(stations.size());
  const auto at = [&](Eigen::Index i) -> const MatchedStation& { return stations[static_cast<std::size_t>(i)]; };
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto near = [&](Eigen::Index j) {
      return std::abs(std::remainder(at(j).direction - at(i).direction, kTwoPi)) <= kNear;
    };
    std::vector<Eigen::Index> beside = {i};
    for (Eigen::Index k = 1; k < n && near((i + k) % n); ++k) beside.push_back((i + k) % n);
    for (Eigen::Index k = 1; k < n && near((i + n - k) % n); ++k) beside.push_back((i + n - k) % n);
    if (beside.size() < 5) beside.clear();
    beside_.push_back(std::move(beside));
    reach_.push_back(kOutlier * at(i).own());
  }
}

Eigen::VectorXd Steadied::of(const Eigen::VectorXd& dz) const {
  Eigen::VectorXd steadied = dz;
  std::vector<double> around;
  for (std::size_t i = 0; i < beside_.size(); ++i) {
    const double here = dz[static_cast<Eigen::Index>(i)], reach = reach_[i];
    std::size_t far = 0;  // the median is no further off than half of the stations are
    for (const Eigen::Index j : beside_[i]) far += std::abs(dz[j] - here) > reach ? 1 : 0;
    if (2 * far < beside_[i].size() || beside_[i].empty()) continue;
    around.clear();
    for (const Eigen::Index j : beside_[i]) around.push_back(dz[j]);
    const auto middle = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), middle, around.end());
    if (std::abs(here - *middle) > reach) steadied[static_cast<Eigen::Index>(i)] = *middle;
  }
  return steadied;
}

UnmovedDraws drawUnmoved(const std::vector<MatchedStation>& stations, const Removed& rest, const Removed& left,
                         const CommonErrors& common, double correlation) {
  Unmoved unmoved(stations, common, correlation);
  const Steadied steadied_rest(rest.stations), steadied_left(left.stations);
  const std::vector<double> sigmas = sigmasOf(rest.stations, common.turn);
  UnmovedDraws draws;
  for (std::size_t draw = 0; draw < kDraws; ++draw) {
    const Eigen::VectorXd errors = unmoved.draw();
    draws.largest_rest.push_back(largestOf(steadied_rest.of(rest.part.without(errors)), sigmas));
    const Eigen::VectorXd dz = steadied_left.of(left.part.without(errors) + unmoved.registration());
    draws.dz.insert(draws.dz.end(), dz.begin(), dz.end());
  }
  return draws;
}

std::vector<double> sigmasOf(const std::vector<MatchedStation>& stations, double turn) {
  std::vector<double> sigmas;
  for (const MatchedStation& m : stations) sigmas.push_back(std::hypot(m.sigma, m.slope * turn));
  return sigmas;
}

double largestOf(const Eigen::VectorXd& dz, const std::vector<double>& sigmas) {
  if (dz.size() == 0) return 0.0;
  const Eigen::VectorXd each = dz.cwiseAbs().cwiseQuotient(Eigen::VectorXd::Map(sigmas.data(), dz.size()));
  return each.maxCoeff<Eigen::PropagateNumbers>();
}

}  // namespace tank_datum
