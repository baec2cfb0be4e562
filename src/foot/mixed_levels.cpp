#include "foot/mixed_levels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/statistics.h"
#include "fit/circular_series.h"
#include "foot/foot_check.h"
#include "foot/section_end.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Elevations as fits, all of them as uncertain as neighbours differ.
std::vector<FootFit> asFits(const std::vector<double>& elevations) {
  constexpr double kLeast = 1e-7;  // [m]
  const std::size_t count = elevations.size();
  std::vector<double> differences;
  for (std::size_t i = 0; i < count; ++i) differences.push_back(elevations[(i + 1) % count] - elevations[i]);
  const double sigma = std::max(robustSigma(finiteOf(differences), 0.0) / std::sqrt(2.0), kLeast);
  std::vector<FootFit> fits(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::isfinite(elevations[i])) fits[i].z = elevations[i], fits[i].sigma = sigma;
  }
  return fits;
}

/// The elevations without those of runs that stand off longer ones by a step.
std::vector<double> withoutSteps(std::vector<double> elevations, double arc) {
  const Steps steps = findSteps(asFits(elevations), arc, [](const StepRun&) { return false; });
  for (std::size_t i = 0; i < elevations.size(); ++i) {
    if (steps.dropped[i]) elevations[i] = kUnknown;
  }
  return elevations;
}

/// Whether what some stations show lies below what the others do, by a good part of a height.
bool liesBelow(const std::vector<double>& some, const std::vector<double>& others, double height) {
  constexpr double kGoodPart = 0.5;
  const std::vector<double> level = filledUp(others);
  std::vector<double> lower;
  for (std::size_t i = 0; i < some.size(); ++i) lower.push_back(level[i] - some[i]);
  return median(finiteOf(lower)) > kGoodPart * height;
}

}  // namespace

OneLevel ofOneLevel(const std::vector<double>& known, const FootProfile& section, double arc, double reach) {
  std::vector<double> most = withoutSteps(known, arc);
  std::vector<double> rest = known;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (std::isfinite(most[i])) rest[i] = kUnknown;
  }
  if (finiteOf(rest).empty()) return {};
  rest = withoutSteps(std::move(rest), arc);
  const double pipe = heightOfPipe(section, reach);
  if (pipe > 0.0 && liesBelow(rest, most, pipe)) return {std::move(rest), pipe};
  return {std::move(most), 0.0};
}

bool goesOnFarther(const FootProfile& section, const FootProfile& other) {
  return section.valid() && section.edge > other.edge + other.blur;
}

}  // namespace tank_datum
