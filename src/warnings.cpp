#include <algorithm>
#include <cmath>

#include "core/plain_text.h"
#include "refusals.h"
#include "tank_datum/datum.h"

namespace tank_datum {
namespace {

std::string namesOfBad(const std::vector<Setup>& setups) {
  std::string names;
  for (const Setup& setup : setups) {
    if (setup.verdict == SetupVerdict::Bad) names += (names.empty() ? "" : ", ") + setup.name;
  }
  return names;
}

}  // namespace

std::vector<std::string> warningsOf(const Datum& datum) {
  constexpr double kAbove = 0.2;  // stairs and rails stand over a shell [m]
  std::vector<std::string> warnings;
  std::string units = doubtfulUnits(datum.circle.radius);
  if (!units.empty()) warnings.push_back(std::move(units));
  double seen = 0.0;
  for (const ShellPoint& point : datum.shell.points) seen = std::max(seen, point.height);
  if (datum.asked_height < seen - kAbove) {
    warnings.push_back(formatted("a shell height of %.2f m was given, and the shell is seen up to %.2f m: is it in m?",
                                 datum.asked_height, seen));
  }
  if (const std::string bad = namesOfBad(datum.agreement.setups); !bad.empty() && datum.shell.valid()) {
    warnings.push_back(
        formatted("roundness and plumbness are of the points as they are registered, off by up to "
                  "%.2g mm in plan (%s): leave those out to have them of the others",
                  1e3 * datum.agreement.errorsOfPoints().plan, bad.c_str()));
  }
  if (datum.refined.rounding > 0.0) {
    warnings.push_back(formatted("elevations are rounded to %.3g mm; sigma_z holds what that leaves of them unknown",
                                 1e3 * datum.refined.rounding));
  }
  if (datum.refined.narrow_lip > 0.0) {
    warnings.push_back(formatted(
        "the lip is narrower than can be fitted: what it lies on was, and elevations are raised to the lip's, "
        "by %.2g mm usually",
        1e3 * datum.refined.narrow_lip));
  }
  if (datum.refined.maybe_pipe > 0.0) {
    warnings.push_back(
        formatted("what passes for a lip is %.2g mm high and stands out hardly farther: it may be a pipe or a cable "
                  "upon the foot; sigma_z holds half of that",
                  1e3 * datum.refined.maybe_pipe));
  }
  if (datum.refined.liquid >= 1.0) {
    warnings.push_back(
        "all that meets the shell is level and without slope: if liquid or sludge stands in the tank, it lies on the "
        "floor");
  } else if (datum.refined.liquid > 0.0) {
    warnings.push_back(
        formatted("%.0f %% of what meets the shell is level and without slope as the floor beside it is not: liquid "
                  "or sludge hides the floor there, and it is not measured",
                  100.0 * datum.refined.liquid));
  }
  return warnings;
}

}  // namespace tank_datum
