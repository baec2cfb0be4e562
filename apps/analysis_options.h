#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "tank_datum/shape/analysis.h"

namespace tank_datum {

/// What a person types for the code checks.
struct TypedAnalysis {
  std::optional<double> height, yield_mpa, modulus_mpa;
  std::string roof, foundation, limits;
  int classic_points = AnalysisOptions().classic_points;
};

void addAnalysisOptions(CLI::App& app, TypedAnalysis& typed);

/// The options meant.
/// @throws Error  a file of limits that cannot be read or is refused
AnalysisOptions analysisOptions(const TypedAnalysis& typed);

}  // namespace tank_datum
