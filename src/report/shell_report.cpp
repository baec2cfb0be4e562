#include "report/shell_report.h"

#include <cmath>

#include "core/azimuth.h"
#include "core/plain_text.h"
#include "core/units.h"
#include "report/summary_line.h"

namespace tank_datum {
namespace {

/// The foot's radii, or the lowest height's when the foot is not seen.
std::string roundnessLine(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances,
                          const Display& display) {
  const Roundness* r = survey.foot();
  if (!r && !survey.roundness.empty()) r = &survey.roundness.front();
  if (!r) return line("roundness", "the shell is not seen round enough of the tank at any height");
  const auto at = static_cast<std::size_t>(r - survey.roundness.data());
  std::string tolerance = "no tolerance for it";
  if (at < tolerances.size() && std::isfinite(tolerances[at].limit)) {
    const LimitComparison& it = tolerances[at];
    const std::string whose = it.service.empty() ? "" : " of " + it.service + " tanks";  // else it judges nothing here
    tolerance = formatted("tolerance%s %.4g %s", whose.c_str(), display.shortFactor() * it.limit, display.shortUnit());
    if (it.service.empty()) tolerance += ": " + std::string(nameOf(it.verdict));
  }
  return line("roundness", "%s / %s %s at %s above the datum, worst at %.0f deg (%s)",
              display.signedShort(r->max_deviation).c_str(), display.signedShort(r->min_deviation).c_str(),
              display.shortUnit(), display.longText(r->height, 2).c_str(), wholeDegrees(r->azimuth), tolerance.c_str());
}

constexpr double kShownLean = 5e-5;  // [m]: of less, which is 0.0 mm, a direction says nothing

std::string plumbnessLine(const ShellSurvey& survey, const Display& display) {
  const Plumbness* worst = survey.worstPlumbness();
  if (!worst) return line("plumbness", "the shell is seen at one height only");
  std::string lean;
  if (survey.lean.valid() && survey.lean.offset() >= kShownLean) {
    lean = formatted("; the tank leans %s +- %s towards %.0f deg", display.shortText(survey.lean.offset()).c_str(),
                     display.shortText(2.0 * survey.lean.height * survey.lean.sigma).c_str(),
                     wholeDegrees(survey.lean.direction));
  }
  return line("plumbness", "%s +- %s (2 sigma) over %s of height at %.0f deg%s",
              display.signedShort(worst->offset).c_str(), display.shortText(2.0 * worst->sigma).c_str(),
              display.longText(worst->height, 1).c_str(), wholeDegrees(worst->azimuth), lean.c_str());
}

}  // namespace

std::string shellCsv(const ShellSurvey& survey) {
  std::string csv = "azimuth_deg,height,radius,deviation,sigma,n,offset\n";
  for (const ShellPoint& p : survey.points) {
    csv += shortestText(toDegrees(p.azimuth)) + "," + shortestText(p.height) + "," + shortestText(p.radius) + "," +
           shortestText(p.deviation) + "," + shortestText(p.sigma) + "," + std::to_string(p.points) + "," +
           shortestText(p.offset) + "\n";
  }
  return csv;
}

std::string shellSummary(const ShellSurvey& survey, const std::vector<LimitComparison>& tolerances,
                         const Display& display) {
  if (!survey.valid()) return survey.message.empty() ? "" : line("shell", "%s", survey.message.c_str());
  return roundnessLine(survey, tolerances, display) + plumbnessLine(survey, display);
}

}  // namespace tank_datum
