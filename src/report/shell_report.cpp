#include "report/shell_report.h"

#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/units.h"

namespace tank_datum {
namespace {

template <typename... Values>
std::string line(const char* format, Values... values) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return std::string(buffer) + "\n";
}

std::string text(double value) {
  if (!std::isfinite(value)) return {};
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

/// The foot's radii, or the lowest height's when the foot is not seen.
std::string roundnessLine(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances) {
  const Roundness* r = survey.foot();
  if (!r && !survey.roundness.empty()) r = &survey.roundness.front();
  if (!r) return line("%-14s the shell is not seen round enough of the tank at any height", "roundness");
  const auto at = static_cast<std::size_t>(r - survey.roundness.data());
  char tolerance[80] = "no tolerance for it";
  if (at < tolerances.size() && std::isfinite(tolerances[at].limit)) {
    std::snprintf(tolerance, sizeof tolerance, "tolerance %g mm: %s", 1e3 * tolerances[at].limit,
                  nameOf(tolerances[at].verdict));
  }
  return line("%-14s %+.1f / %+.1f mm at %.2f m above the datum, worst at %.0f deg (%s)", "roundness",
              1e3 * r->max_deviation, 1e3 * r->min_deviation, r->height, toDegrees(r->azimuth), tolerance);
}

std::string plumbnessLine(const ShellSurvey& survey) {
  const Plumbness* worst = survey.worstPlumbness();
  if (!worst) return line("%-14s the shell is seen at one height only", "plumbness");
  std::string lean;
  if (survey.lean.valid()) {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "; the tank leans %.1f mm towards %.0f deg", 1e3 * survey.lean.offset(),
                  toDegrees(survey.lean.direction));
    lean = buffer;
  }
  return line("%-14s %+.1f mm over %.1f m of height at %.0f deg%s", "plumbness", 1e3 * worst->offset, worst->height,
              toDegrees(worst->azimuth), lean.c_str());
}

}  // namespace

std::string shellCsv(const ShellSurvey& survey) {
  std::string csv = "azimuth_deg,height,radius,deviation,sigma,n,offset\n";
  for (const ShellPoint& p : survey.points) {
    csv += text(toDegrees(p.azimuth)) + "," + text(p.height) + "," + text(p.radius) + "," + text(p.deviation) + "," +
           text(p.sigma) + "," + std::to_string(p.points) + "," + text(p.offset) + "\n";
  }
  return csv;
}

std::string shellSummary(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances) {
  if (!survey.valid()) return survey.message.empty() ? "" : line("%-14s %s", "shell", survey.message.c_str());
  return roundnessLine(survey, tolerances) + plumbnessLine(survey);
}

}  // namespace tank_datum
