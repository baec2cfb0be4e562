// firstError of every struct of options, from the one table.
#include "core/plain_text.h"
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

/// Of a struct inside the options of a datum, the rest of which are the defaults.
template <typename Part>
std::optional<Refusal> firstOfPart(const Part& options, Part DatumOptions::*part) {
  DatumOptions datum;
  datum.*part = options;
  return firstError(datum);
}

/// Options of which one has no effect beside the other. A file of options holds all: those at their defaults are not
/// meant.
std::optional<Refusal> firstContradiction(const RunOptions& run) {
  const ShellOptions& shell = run.datum.shell;
  if (run.all && run.datum.pick != DatumOptions().pick) {
    return Refusal{"pick", std::to_string(run.datum.pick), "no such option beside option all, which takes every tank"};
  }
  if (run.no_checksum && run.checksum == Checksum::Sha256) {
    return Refusal{"checksum", "sha256", "no such option beside option no_checksum"};
  }
  if (!shell.heights.empty() && shell.step != ShellOptions().step) {
    return Refusal{"height_step", generalText(shell.step), "no such option beside option heights"};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> firstError(const RunOptions& given) {
  RunOptions run = given;
  if (auto refused = firstOf(optionsOf(run))) return refused;
  if (auto refused = firstContradiction(run)) return refused;
  return firstError(run.movement);
}

std::optional<Refusal> firstError(const DatumOptions& options) {
  RunOptions run;
  run.datum = options;
  return firstOf(optionsOf(run));
}

std::optional<Refusal> firstError(const MovementOptions& given) {
  MovementOptions movement = given;
  const std::vector<Option> options = movementOptionsOf(movement);
  if (auto refused = firstOf(options)) return refused;
  if (!movement.estimate_offset || movement.azimuth_offset == 0.0) return std::nullopt;
  return Refusal{"azimuth_offset_deg", generalText(toDegrees(movement.azimuth_offset)),
                 "0 with option estimate_azimuth_offset, which finds it"};
}

std::optional<Refusal> firstError(const LocateOptions& options) { return firstOfPart(options, &DatumOptions::locate); }

std::optional<Refusal> firstError(const CropOptions& options) { return firstOfPart(options, &DatumOptions::crop); }

std::optional<Refusal> firstError(const NormalOptions& options) { return firstOfPart(options, &DatumOptions::normals); }

std::optional<Refusal> firstError(const GrowingOptions& options) {
  return firstOfPart(options, &DatumOptions::growing);
}

std::optional<Refusal> firstError(const CentreFilterOptions& options) {
  return firstOfPart(options, &DatumOptions::centre_filter);
}

std::optional<Refusal> firstError(const SplineOptions& options) { return firstOfPart(options, &DatumOptions::spline); }

std::optional<Refusal> firstError(const SetupOptions& options) { return firstOfPart(options, &DatumOptions::setups); }

std::optional<Refusal> firstError(const RefineOptions& options) { return firstOfPart(options, &DatumOptions::refine); }

std::optional<Refusal> firstError(const StationOptions& options) {
  return firstOfPart(options, &DatumOptions::stations);
}

std::optional<Refusal> firstError(const TankFacts& facts) {
  AnalysisOptions analysis;
  analysis.facts = facts;
  return firstError(analysis);
}

std::optional<Refusal> firstError(const AnalysisOptions& options) {
  return firstOfPart(options, &DatumOptions::analysis);
}

std::optional<Refusal> firstError(const ShellOptions& options) { return firstOfPart(options, &DatumOptions::shell); }

}  // namespace tank_datum
