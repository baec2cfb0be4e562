// firstError of every struct of options, from the one table.
#include <sstream>

#include "core/units.h"
#include "options/option_table.h"

namespace tank_datum {
namespace {

std::optional<Refusal> firstOf(const std::vector<Option>& options) {
  for (const Option& option : options) {
    if (std::optional<Refusal> refused = option.refused()) return refused;
  }
  return std::nullopt;
}

/// Of a struct inside the options of a run, the rest of which are the defaults.
template <typename Options, typename Part>
std::optional<Refusal> firstOfPart(const Options& options, Part part) {
  RunOptions run;
  part(run) = options;
  return firstOf(optionsOf(run));
}

}  // namespace

std::optional<Refusal> firstError(const RunOptions& given) {
  RunOptions run = given;
  if (auto refused = firstOf(optionsOf(run))) return refused;
  return firstError(run.movement);
}

std::optional<Refusal> firstError(const DatumOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum; });
}

std::optional<Refusal> firstError(const MovementOptions& given) {
  MovementOptions movement = given;
  const std::vector<Option> options = movementOptionsOf(movement);
  if (auto refused = firstOf(options)) return refused;
  if (!movement.estimate_offset || movement.azimuth_offset == 0.0) return std::nullopt;
  std::ostringstream degrees;
  degrees << toDegrees(movement.azimuth_offset);
  return Refusal{"azimuth_offset_deg", degrees.str(), "0 with option estimate_azimuth_offset, which finds it"};
}

std::optional<Refusal> firstError(const LocateOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.locate; });
}

std::optional<Refusal> firstError(const CropOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.crop; });
}

std::optional<Refusal> firstError(const NormalOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.normals; });
}

std::optional<Refusal> firstError(const GrowingOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.growing; });
}

std::optional<Refusal> firstError(const CentreFilterOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.centre_filter; });
}

std::optional<Refusal> firstError(const SplineOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.spline; });
}

std::optional<Refusal> firstError(const SetupOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.setups; });
}

std::optional<Refusal> firstError(const RefineOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.refine; });
}

std::optional<Refusal> firstError(const StationOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.stations; });
}

std::optional<Refusal> firstError(const TankFacts& facts) {
  return firstOfPart(
      facts, [](RunOptions & run) -> auto& { return run.datum.analysis.facts; });
}

std::optional<Refusal> firstError(const AnalysisOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.analysis; });
}

std::optional<Refusal> firstError(const ShellOptions& options) {
  return firstOfPart(
      options, [](RunOptions & run) -> auto& { return run.datum.shell; });
}

}  // namespace tank_datum
