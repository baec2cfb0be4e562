#include "analysis_options.h"

#include "tank_datum/core/unknown.h"

namespace tank_datum {

void addAnalysisOptions(CLI::App& app, TypedAnalysis& typed) {
  app.add_option("--height", typed.height, "shell height H for the code checks [m]");
  app.add_option("--yield-mpa", typed.yield_mpa, "yield strength Y of the shell's steel [MPa]");
  app.add_option("--modulus-mpa", typed.modulus_mpa, "its elastic modulus E [MPa]");
  app.add_option("--roof", typed.roof, "open (floating) or fixed")->check(CLI::IsMember({"", "open", "fixed"}));
  app.add_option("--foundation", typed.foundation, "ringwall or earth")
      ->check(CLI::IsMember({"", "ringwall", "earth"}));
  app.add_option("--classic-points", typed.classic_points,
                 "survey points for the classic out-of-plane rule; 0: every 20 ft, or the stations typed in");
  app.add_option("--limits", typed.limits, "file of limits to judge by, as --print-limits writes it");
}

AnalysisOptions analysisOptions(const TypedAnalysis& typed) {
  AnalysisOptions options;
  options.facts.height = typed.height.value_or(kUnknown);
  options.facts.yield = typed.yield_mpa.value_or(kUnknown);
  options.facts.modulus = typed.modulus_mpa.value_or(kUnknown);
  options.facts.roof = typed.roof;
  options.facts.foundation = typed.foundation;
  options.classic_points = typed.classic_points;
  options.limits_file = typed.limits;
  if (!typed.limits.empty()) options.limits = readLimits(typed.limits);
  return options;
}

}  // namespace tank_datum
