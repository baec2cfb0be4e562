#include "shape/survey_rows.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/units.h"
#include "limits/survey_spacing.h"

namespace tank_datum {
namespace {

/// Three neighbouring survey points and the arcs between them [m].
struct Triple {
  double azimuth;
  RingPlace before, here, after;
  double to_before, to_after;
};

/// Calls `use` with every triple of points that have values.
void forEachTriple(const RingSeries& series, const SurveyPlan& plan, double radius,
                   const std::function<void(const Triple&)>& use) {
  const std::vector<RingValue>& v = series.values();
  const double widest = std::max(kWidestSpacing, 1.01 * plan.spacing);
  if (plan.as_they_are) {
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::size_t a = (i + v.size() - 1) % v.size(), b = (i + 1) % v.size();
      const double left = radius * turnAhead(v[a].azimuth, v[i].azimuth);
      const double right = radius * turnAhead(v[i].azimuth, v[b].azimuth);
      const bool near = left <= widest && right <= widest && series.joined(a) && series.joined(i);
      if (near && v.size() > 2) use({v[i].azimuth, {a, a, 0.0}, {i, i, 0.0}, {b, b, 0.0}, left, right});
    }
    return;
  }
  const double step = kTwoPi / plan.points;
  for (const double start : plan.starts) {
    for (int i = 0; i < plan.points; ++i) {
      const double azimuth = start + i * step;
      const auto before = series.placeOf(azimuth - step), here = series.placeOf(azimuth),
                 after = series.placeOf(azimuth + step);
      if (before && here && after) use({azimuth, *before, *here, *after, plan.spacing, plan.spacing});
    }
  }
}

/// Distance of the middle from the chord.
std::vector<std::pair<RingPlace, double>> chordParts(const Triple& t, double over) {
  const double whole = t.to_before + t.to_after;
  return {{t.here, 1.0 / over}, {t.before, -t.to_after / whole / over}, {t.after, -t.to_before / whole / over}};
}

}  // namespace

RingRows secondDifferenceRows(const RingSeries& series, const SurveyPlan& plan, double radius) {
  RingRows rows;
  forEachTriple(series, plan, radius, [&](const Triple& t) {
    rows.add(t.azimuth, chordParts(t, 1.0), plan.spacing * plan.spacing / (t.to_before * t.to_after));
  });
  return rows;
}

RingRows distortionRows(const RingSeries& series, const SurveyPlan& plan, double radius) {
  RingRows rows;
  forEachTriple(series, plan, radius,
                [&](const Triple& t) { rows.add(t.azimuth, chordParts(t, 0.5 * (t.to_before + t.to_after))); });
  return rows;
}

RingRows neighbourRows(const RingSeries& series, const SurveyPlan& plan, double radius) {
  RingRows rows;
  const std::vector<RingValue>& v = series.values();
  const double step = kTwoPi / plan.points;
  for (std::size_t i = 0; plan.as_they_are && i < v.size(); ++i) {
    const std::size_t next = (i + 1) % v.size();
    const double arc = radius * turnAhead(v[i].azimuth, v[next].azimuth);
    if (series.joined(i) && v.size() > 1)
      rows.add(v[i].azimuth, {{{next, next, 0.0}, 1.0 / arc}, {{i, i, 0.0}, -1.0 / arc}});
  }
  for (std::size_t s = 0; !plan.as_they_are && s < plan.starts.size(); ++s) {
    for (int i = 0; i < plan.points; ++i) {
      const double azimuth = plan.starts[s] + i * step;
      const auto here = series.placeOf(azimuth), next = series.placeOf(azimuth + step);
      if (here && next) rows.add(azimuth, {{*next, 1.0 / plan.spacing}, {*here, -1.0 / plan.spacing}});
    }
  }
  return rows;
}

}  // namespace tank_datum
