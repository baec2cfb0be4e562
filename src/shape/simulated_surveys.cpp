#include "shape/simulated_surveys.h"

#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/units.h"
#include "fit/harmonics.h"
#include "stations/ring_series.h"

namespace tank_datum {
namespace {

constexpr int kDraws = 400;
constexpr std::uint64_t kSeed = 6531012;

/// Stations with a value everywhere: missing ones, and more where none stand over twice their mean distance.
std::vector<Station> filled(const std::vector<Station>& stations) {
  std::vector<Station> whole;
  const double mean = kTwoPi / static_cast<double>(std::max<std::size_t>(1, stations.size()));
  const auto put = [&whole](double azimuth) {
    whole.emplace_back();
    whole.back().azimuth = withinTurn(azimuth);
    whole.back().z = whole.back().u = 0.0;
    whole.back().flag = StationFlag::Measured;
  };
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const double here = stations[i].azimuth;
    put(here);
    const double ahead = stations.size() > 1 ? turnAhead(here, stations[(i + 1) % stations.size()].azimuth) : kTwoPi;
    const double parts = ahead > 2.0 * mean ? std::ceil(ahead / mean) : 1.0;
    for (double k = 1.0; k < parts; ++k) put(here + ahead * k / parts);
  }
  std::sort(whole.begin(), whole.end(), [](const Station& a, const Station& b) { return a.azimuth < b.azimuth; });
  return whole;
}

std::vector<Station> withElevation(const std::vector<Station>& stations) {
  std::vector<Station> known;
  std::copy_if(stations.begin(), stations.end(), std::back_inserter(known),
               [](const Station& s) { return std::isfinite(s.z); });
  return known;
}

Eigen::VectorXd columnOf(const std::vector<Station>& stations, double Station::*value) {
  Eigen::VectorXd column(static_cast<Eigen::Index>(stations.size()));
  std::transform(stations.begin(), stations.end(), column.begin(), [value](const Station& s) { return s.*value; });
  return column;
}

/// The order statistic that leaves 2.5 % of the draws beyond it.
double beyond(std::vector<double> values, bool above) {
  const std::size_t tail = values.size() / 40;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(above ? values.size() - 1 - tail : tail);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

SimulatedSurveys::SimulatedSurveys(const std::vector<Station>& stations, double radius,
                                   const StationCovariance& covariance)
    : radius_(radius), model_(ringData(stations, radius, covariance)), whole_(filled(stations)) {
  valid_ = model_.order() > 0 && (model_.dense() || model_.data().sigmas_known);
  if (!valid_) return;
  known_ = withElevation(stations);
  known_azimuths_ = columnOf(known_, &Station::azimuth);
  whole_azimuths_ = columnOf(whole_, &Station::azimuth);
  draws_ = model_.simulate(kDraws, kSeed);
  const Eigen::MatrixXd rows = model_.rowsAt(columnOf(stations, &Station::azimuth));
  const Eigen::VectorXd variances = RingModel::product(rows, model_.covariance()).cwiseProduct(rows).rowwise().sum();
  doubts_ = RingDoubts(stations, rows * model_.coefficients(), variances.cwiseMax(0.0).cwiseSqrt());
  doubted_ = doubts_.drawn(kDraws, kSeed + 1);
  z_ = valuesOf(false);
  u_ = valuesOf(true);
}

SimulatedSurveys::Values SimulatedSurveys::valuesOf(bool of_u) const {
  const Eigen::Index first = of_u ? 3 : 0, count = model_.coefficients().size() - first;
  const auto at = [&](const Eigen::VectorXd& azimuths) {
    return Eigen::MatrixXd(model_.rowsAt(azimuths).rightCols(count));
  };
  const Eigen::MatrixXd rows = at(known_azimuths_);
  Values values;
  values.truths = RingModel::product(rows, draws_.truth.bottomRows(count));
  values.whole = whole_azimuths_.size() == known_azimuths_.size()
                     ? values.truths
                     : RingModel::product(at(whole_azimuths_), draws_.truth.bottomRows(count));
  const auto doubts_at = [&](const Eigen::VectorXd& azimuths) -> Eigen::MatrixXd {
    if (!of_u) return doubts_.at(azimuths);
    return doubts_.at(azimuths) - RingModel::product(harmonicRows(azimuths, 1), doubts_.waves(1));
  };
  addDoubts(doubts_at, values);
  values.standing = rows * model_.standing().tail(count);
  if (!model_.dense()) return raw(std::move(values), of_u);
  values.estimates = RingModel::product(rows, draws_.estimate.bottomRows(count));
  values.surveyed = rows * model_.coefficients().tail(count);
  return values;
}

/// @param doubts_at  what each gap in doubt adds at azimuths [places x gaps]
void SimulatedSurveys::addDoubts(const std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>& doubts_at,
                                 Values& values) const {
  values.possible = values.truths;
  if (doubts_.empty()) return;
  values.possible += RingModel::product(doubts_at(known_azimuths_), doubted_);
  values.whole += RingModel::product(doubts_at(whole_azimuths_), doubted_);
}

/// Of few stations the figures are of the elevations as they were surveyed, less their plane; between them, where an
/// elevation is interpolated, a survey gives what the model makes of it.
SimulatedSurveys::Values SimulatedSurveys::raw(Values values, bool of_u) const {
  values.estimates = RingModel::product(model_.rowsAt(known_azimuths_), draws_.estimate);
  Eigen::Index measured = 0;
  for (std::size_t i = 0; i < known_.size(); ++i) {
    if (known_[i].flag != StationFlag::Measured) continue;
    values.estimates.row(static_cast<Eigen::Index>(i)) = draws_.survey.row(measured++);
  }
  values.surveyed = columnOf(known_, &Station::z);
  if (!of_u) return values;
  const Eigen::MatrixXd plane = harmonicRows(model_.data().azimuths, 1);
  const Eigen::VectorXd weights = model_.data().sigmas.array().square().inverse();
  const Eigen::MatrixXd weighted = plane.transpose() * weights.asDiagonal();
  const Eigen::MatrixXd fit = (weighted * plane).ldlt().solve(weighted);
  const Eigen::MatrixXd everywhere = harmonicRows(known_azimuths_, 1);
  values.estimates -= RingModel::product(everywhere, RingModel::product(fit, draws_.survey));
  values.surveyed -= everywhere * (fit * model_.data().z);
  return values;
}

/// By how much each survey's figure is above the truth's: at the whole ring, if that is asked for.
std::vector<double> SimulatedSurveys::missedBy(const Values& values, const RingFigure& seen, const RingFigure& whole) {
  std::vector<double> missed;
  for (Eigen::Index k = 0; k < values.truths.cols(); ++k) {
    const double truth = whole ? whole(values.whole.col(k).data()) : seen(values.possible.col(k).data());
    missed.push_back(seen(values.estimates.col(k).data()) - truth);
  }
  return missed;
}

Interval95 SimulatedSurveys::interval(const Values& values, const RingFigure& seen, const RingFigure& whole) {
  const double surveyed = seen(values.surveyed.data()), standing = seen(values.standing.data());
  std::vector<double> raised;
  Eigen::VectorXd disturbed;
  for (Eigen::Index k = 0; k < values.truths.cols(); ++k) {
    disturbed = values.standing + values.estimates.col(k) - values.truths.col(k);
    raised.push_back(seen(disturbed.data()) - standing);
  }
  const double low = std::max(0.0, surveyed - beyond(std::move(raised), true));
  return {low, std::max(low, surveyed - beyond(missedBy(values, seen, whole), false))};
}

Interval95 SimulatedSurveys::intervalOf(const RingFigure& seen, const RingFigure& whole, bool of_u) const {
  return valid_ ? widened(of_u ? u_ : z_, seen, whole) : Interval95{};
}

Interval95 SimulatedSurveys::aboutWhole(const RingFigure& seen, const RingFigure& whole) const {
  const Interval95 all_seen = intervalOf(seen, whole, false);
  if (!valid_ || whole_azimuths_.size() == known_azimuths_.size()) return all_seen;
  const double surveyed = seen(z_.surveyed.data());
  const std::vector<double> missed = missedBy(z_, seen, whole);
  const double low = std::max(0.0, std::min(all_seen.low, surveyed - beyond(missed, true)));
  return {low, std::max(low, surveyed - beyond(missed, false))};
}

SimulatedSurveys::Values SimulatedSurveys::wavesTo(int order, bool curvature) const {
  const int highest = std::min(order, model_.order());
  const Eigen::Index count = 2 * highest - 2;
  const auto at = [&](const Eigen::VectorXd& azimuths) {
    Eigen::MatrixXd rows = harmonicRows(azimuths, highest).rightCols(count);
    for (int n = 2; curvature && n <= highest; ++n) rows.middleCols(2 * n - 4, 2) *= (n / radius_) * (n / radius_);
    return rows;
  };
  const auto middle = [&](const Eigen::MatrixXd& all) { return Eigen::MatrixXd(all.middleRows(3, count)); };
  const Eigen::MatrixXd rows = at(known_azimuths_);
  Values values;
  values.truths = RingModel::product(rows, middle(draws_.truth));
  values.whole = whole_azimuths_.size() == known_azimuths_.size()
                     ? values.truths
                     : RingModel::product(at(whole_azimuths_), middle(draws_.truth));
  const auto doubts_at = [&](const Eigen::VectorXd& azimuths) {
    return RingModel::product(at(azimuths), doubts_.waves(highest).bottomRows(count));
  };
  addDoubts(doubts_at, values);
  values.estimates = RingModel::product(rows, middle(draws_.estimate));
  values.surveyed = rows * model_.coefficients().segment(3, count);
  values.standing = rows * model_.standing().segment(3, count);
  return values;
}

Interval95 SimulatedSurveys::ofWaves(int order, const RingFigure& seen) const {
  return valid_ && order > 1 ? widened(wavesTo(order, false), seen, {}) : Interval95{};
}

Interval95 SimulatedSurveys::curvature(int order) const {
  if (!valid_ || order < 2) return {};
  const Values values = wavesTo(order, true);
  const auto largest = [](Eigen::Index places) {
    return [places](const double* v) { return Eigen::Map<const Eigen::VectorXd>(v, places).cwiseAbs().maxCoeff(); };
  };
  Interval95 result = interval(values, largest(values.truths.rows()), largest(values.whole.rows()));
  // the shortest waves bend most and are known least: no less than what is as likely as the survey
  std::vector<double> likely;
  for (Eigen::Index k = 0; k < values.whole.cols(); ++k) likely.push_back(values.whole.col(k).cwiseAbs().maxCoeff());
  result.high = std::max(result.high, beyond(std::move(likely), true));
  return result;
}

/// Sigmas that are several times what stations scatter by would raise the figure by more than it is: its upper end is
/// then no less than that of what is as likely as the survey.
Interval95 SimulatedSurveys::widened(const Values& values, const RingFigure& seen, const RingFigure& whole) const {
  Interval95 result = interval(values, seen, whole);
  if (!model_.noise().is_overstated) return result;
  std::vector<double> likely;
  for (Eigen::Index k = 0; k < values.truths.cols(); ++k) {
    likely.push_back(whole ? whole(values.whole.col(k).data()) : seen(values.possible.col(k).data()));
  }
  result.high = std::max(result.high, beyond(std::move(likely), true));
  return result;
}

}  // namespace tank_datum
