#include "shape/figures.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/normal95.h"
#include "core/plain_text.h"
#include "shape/arc_points.h"
#include "shape/level_rows.h"
#include "shape/ring_fits.h"
#include "shape/second_differences.h"
#include "shape/survey_rows.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

/// The values themselves.
RingRows valueRows(const RingSeries& series) {
  RingRows rows;
  for (std::size_t i = 0; i < series.values().size(); ++i) rows.add(series.values()[i].azimuth, {{{i, i, 0.0}, 1.0}});
  return rows;
}

const char* const kTooFew = "too few stations have an elevation";

}  // namespace

Figures::Figures(const std::vector<Station>& stations, double radius, const SimulatedSurveys& surveys)
    : stations_(stations),
      radius_(radius),
      surveys_(surveys),
      seen_{RingSeries(stations, &Station::u, &Station::sigma_z), RingSeries(stations, &Station::z, &Station::sigma_z)},
      whole_{RingSeries(surveys.wholeRing(), &Station::u, &Station::sigma_z),
             RingSeries(surveys.wholeRing(), &Station::z, &Station::sigma_z)} {}

Measure& Figures::add(const std::string& quantity, const PlacedValue& worst, const char* without) {
  Measure measure;
  measure.quantity = quantity;
  measure.worst = worst;
  if (!std::isfinite(worst.value)) measure.unavailable = without;
  all_.push_back(measure);
  return all_.back();
}

Interval95 Figures::intervalOf(const RingRows& seen, const RingRows& whole, bool of_u) const {
  if (seen.empty()) return {};
  return surveys_.intervalOf([&](const double* v) { return seen.largest(v); },
                             [&](const double* v) { return whole.largest(v); }, of_u);
}

void Figures::addNeighbours(const SecondDifferences& differences, const SurveyPlan& plan) {
  const std::string none = "no survey points 15 to 32 ft apart: " + plan.message;
  const bool known = differences.valid();
  Measure& s =
      add("second_difference", known ? differences.all[differences.worst] : PlacedValue{}, differences.message.c_str());
  if (!plan.valid()) {
    add("neighbour_bend", {}, none.c_str());
    add("neighbour_slope", {}, none.c_str());
    return;
  }
  const RingRows bends = secondDifferenceRows(seen_.u, plan, radius_);
  s.all = differences.all;
  s.spacing = known ? differences.spacings[differences.worst] : differences.spacing;
  if (known) {
    const Interval95 scaled = intervalOf(bends, secondDifferenceRows(whole_.u, plan, radius_), true);
    const double scale = bends.scale(differences.worst);
    s.interval = {scaled.low / scale, scaled.high / scale};
    s.note = formatted("%d points %.2f m apart from %d start angle%s", differences.points, differences.spacing,
                       differences.starts, differences.starts == 1 ? "" : "s") +
             (differences.message.empty() ? "" : "; " + differences.message);
  }
  const RingRows distortions = distortionRows(seen_.u, plan, radius_), slopes = neighbourRows(seen_.z, plan, radius_);
  add("neighbour_bend", distortions.largestOf(seen_.u.values()), kTooFew).interval =
      intervalOf(distortions, distortionRows(whole_.u, plan, radius_), true);
  add("neighbour_slope", slopes.largestOf(seen_.z.values()), kTooFew).interval =
      intervalOf(slopes, neighbourRows(whole_.z, plan, radius_), false);
}

void Figures::addLevels(Analysis& analysis) {
  const RingRows slopes = slopeRows(seen_.z, radius_, 10.0);
  add("slope_10m", slopes.largestOf(seen_.z.values()), kTooFew).interval =
      intervalOf(slopes, slopeRows(whole_.z, radius_, 10.0), false);
  for (const auto& [quantity, arc] : {std::pair("level_9m", 9.0), {"level_3m", 3.0}}) {
    const LevelWithin seen(seen_.z, radius_, arc), whole(whole_.z, radius_, arc);
    PlacedValue& level = arc > 3.0 ? analysis.level_9m : analysis.level_3m;
    level = seen.largest(seen_.z.values());
    Measure& measure = add(quantity, level, "no two neighbouring stations have an elevation");
    if (seen.empty()) continue;
    measure.interval = surveys_.intervalOf([&](const double* v) { return seen.largest(v); },
                                           [&](const double* v) { return whole.largest(v); }, false);
  }
  const MeanLevel seen(seen_.z, stations_), whole(whole_.z, surveys_.wholeRing());
  analysis.level_total = seen.furthest(seen_.z.values());
  add("level_total", analysis.level_total, kTooFew).interval = surveys_.aboutWhole(
      [&](const double* v) { return seen.furthest(v); }, [&](const double* v) { return whole.furthest(v); });
}

void Figures::addCurvature(OutOfPlane& fit) {
  Measure& measure =
      add("curvature", {fit.max_curvature, fit.sigma_curvature, fit.max_curvature_azimuth}, fit.message.c_str());
  if (!fit.valid()) return;
  fit.curvature_interval = surveys_.curvature(std::max(shortestWave(radius_), fit.order));
  if (fit.curvature_interval.known()) {
    fit.sigma_curvature =
        std::max(fit.curvature_interval.high - fit.max_curvature, fit.max_curvature - fit.curvature_interval.low) /
        kNormal95;
  }
  measure.interval = fit.curvature_interval;
  measure.note = formatted("waves up to n = %d", fit.order);
}

void Figures::addOutOfPlane(OutOfPlane& fit) {
  const RingRows rows = valueRows(seen_.u);
  Measure& measure = add("out_of_plane", rows.largestOf(seen_.u.values()), kTooFew);
  measure.interval = fit.u_interval = intervalOf(rows, valueRows(whole_.u), true);
}

void Figures::addArcs(const std::vector<SettlementArc>& arcs) {
  if (arcs.empty()) add("settlement_arc", {}, "the out-of-plane settlement nowhere changes its sign");
  const auto points = std::make_shared<ArcPoints>(stations_, radius_);
  const SimulatedSurveys* surveys = &surveys_;
  const int order = points->ofRegression() ? shortestWave(radius_) : 0;
  for (const SettlementArc& arc : arcs) {
    Measure& measure = add("settlement_arc", arc.largest, kTooFew);
    measure.arc = arc.length;
    measure.note = formatted("arc of %.1f m", arc.length);
    if (!surveys_.valid()) continue;
    measure.share = [points, surveys, order](const std::function<double(double)>& limit) {
      const RingFigure worst = [&](const double* u) {
        double share = 0.0;
        for (const SettlementArc& a : points->arcsOf(points->reduce(u)))
          share = std::max(share, a.largest.value / limit(a.length));
        return share;
      };
      return order > 0 ? surveys->ofWaves(order, worst) : surveys->intervalOf(worst, {}, true);
    };
  }
}

}  // namespace tank_datum
