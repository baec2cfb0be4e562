#include "shell/shell_survey.h"

#include <algorithm>
#include <cmath>

#include "core/normal95.h"
#include "core/plain_text.h"
#include "shell/shell_lean.h"
#include "shell/shell_peaks.h"
#include "shell/shell_plumbness.h"
#include "shell/shell_roundness.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// The radii of all heights, with their offset from the lowest one seen at the same station.
std::vector<ShellPoint> pointsOf(const ShellGrid& grid, const std::vector<std::vector<double>>& deviations,
                                 const std::vector<Station>& stations) {
  std::vector<ShellPoint> points;
  std::vector<double> lowest(stations.size(), kUnknown);
  for (std::size_t k = 0; k < grid.heights.size(); ++k) {
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const ShellCell& cell = grid.cells[k][i];
      if (!cell.seen()) continue;
      if (std::isnan(lowest[i])) lowest[i] = cell.radius;
      points.push_back({stations[i].azimuth, grid.heights[k], cell.radius, deviations[k][i], cell.radius - lowest[i],
                        cell.sigma, cell.points});
    }
  }
  return points;
}

/// The circle that a height has if it is as round as the nearest one whose circle is known, and the tank leans so.
Circle expectedAt(double height, const std::vector<Roundness>& known, const Lean& lean) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const Roundness& a, const Roundness& b) {
    return std::abs(a.height - height) < std::abs(b.height - height);
  });
  Circle circle = nearest->circle;
  if (lean.valid()) circle.center += (height - nearest->height) * lean.gradient;
  return circle;
}

}  // namespace

const Roundness* ShellSurvey::foot() const {
  const Roundness* found = nullptr;
  for (const Roundness& r : roundness) {
    if (isAtFoot(r.height)) found = &r;
  }
  return found;
}

const Roundness* ShellSurvey::worstAbove() const {
  const Roundness* worst = nullptr;
  for (const auto* rows : {&roundness, &arcs}) {
    for (const Roundness& r : *rows) {
      if (!isAtFoot(r.height) && (!worst || r.largest() > worst->largest())) worst = &r;
    }
  }
  return worst;
}

const Plumbness* ShellSurvey::worstPlumbness() const {
  const auto surely = [](const Plumbness& p) { return std::abs(p.offset) - kNormal95 * p.sigma; };
  const Plumbness* worst = nullptr;
  for (const Plumbness& p : plumbness) {
    if (!worst || surely(p) > surely(*worst)) worst = &p;
  }
  return worst;
}

ShellSurvey surveyShell(const ShellBands& bands, const std::vector<Station>& stations, const Circle& circle,
                        const ShellOptions& options, const StationOptions& station_options) {
  ShellSurvey survey;
  ShellGrid grid = fitShellGrid(bands, stations, circle, options);
  keepConnected(grid);
  std::vector<std::vector<double>> deviations(grid.heights.size());
  std::vector<std::size_t> partly;
  for (std::size_t k = 0; k < grid.heights.size(); ++k) {
    const Roundness roundness = roundnessOf(grid.cells[k], grid.heights[k], stations, circle, deviations[k]);
    if (roundness.circle.valid()) {
      survey.roundness.push_back(roundness);
    } else {
      partly.push_back(k);
    }
  }
  raisePeaks(survey.roundness, grid, deviations, stations);
  survey.plumbness = plumbnessOf(grid, stations);
  survey.lean = leanOf(survey.plumbness, station_options);
  for (const std::size_t k : partly) {
    if (survey.roundness.empty()) break;
    const Circle expected = expectedAt(grid.heights[k], survey.roundness, survey.lean);
    const Roundness arc = arcOf(grid.cells[k], grid.heights[k], stations, circle, expected);
    if (arc.circle.valid()) survey.arcs.push_back(arc);
  }
  survey.points = pointsOf(grid, deviations, stations);
  if (!survey.valid()) {
    char text[96];
    snprintfPlain(text, sizeof text, "the scan holds no shell %g m or more above the datum", bands.heights().front());
    survey.message = text;
  }
  return survey;
}

ShellSurvey withSetupErrors(ShellSurvey survey, const SetupSpread& error, std::size_t setups) {
  for (auto* rows : {&survey.roundness, &survey.arcs}) {
    for (Roundness& r : *rows) r.sigma = std::hypot(r.sigma, error.plan);
  }
  for (Plumbness& p : survey.plumbness) p.sigma = std::hypot(p.sigma, error.plan, error.tilt * p.height);
  const double axis = std::sqrt(2.0 / static_cast<double>(std::max<std::size_t>(2, setups)));  // of one, the whole ring
  survey.lean.sigma = std::hypot(survey.lean.sigma, axis * error.tilt);
  return survey;
}

}  // namespace tank_datum
