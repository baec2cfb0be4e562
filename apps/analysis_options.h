#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// What a person types for the code checks.
struct TypedAnalysis {
  std::string height;
  std::optional<double> yield_mpa, modulus_mpa;
  std::string roof, foundation, limits, service = nameOf(AnalysisOptions().facts.service);
  int classic_points = AnalysisOptions().classic_points;
};

void addAnalysisOptions(CLI::App& app, TypedAnalysis& typed);

/// A length as "8", "8m", "26.25 ft", "315in", "8000mm" [m]; a number alone is metres.
/// @param option  it is of, for the refusal
/// @throws Error (Option) for anything else
double lengthFrom(const std::string& option, const std::string& typed);

/// The options meant.
/// @throws Error  a length or of limits that cannot be read or is refused
AnalysisOptions analysisOptions(const TypedAnalysis& typed);

}  // namespace tank_datum
