#include "analysis_options.h"

#include <charconv>

#include "core/length_units.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

void addAnalysisOptions(CLI::App& app, TypedAnalysis& typed) {
  app.add_option("--height", typed.height,
                 "shell height H for the code checks, as 8, 8m, 26.25ft, 315in; a number alone is metres");
  app.add_option("--yield-mpa", typed.yield_mpa, "yield strength Y of the shell's steel [MPa]");
  app.add_option("--modulus-mpa", typed.modulus_mpa, "its elastic modulus E [MPa]");
  app.add_option("--roof", typed.roof, "open (floating) or fixed")->check(CLI::IsMember({"", "open", "fixed"}));
  app.add_option("--foundation", typed.foundation, "ringwall or earth")
      ->check(CLI::IsMember({"", "ringwall", "earth"}));
  app.add_option("--service", typed.service, "whose rules are judged by: of a new, rebuilt or in-service tank")
      ->check(CLI::IsMember({"new", "rebuilt", "in-service"}));
  app.add_option("--classic-points", typed.classic_points,
                 "survey points for the classic out-of-plane rule; 0: every 20 ft, or the stations typed in");
  app.add_option("--limits", typed.limits, "file of limits to judge by, as --print-limits writes it");
}

double lengthFrom(const std::string& option, const std::string& typed) {
  double value = 0.0;
  const auto read = std::from_chars(typed.data(), typed.data() + typed.size(), value);
  std::string unit(read.ptr, typed.data() + typed.size());
  unit.erase(0, unit.find_first_not_of(' ') == std::string::npos ? unit.size() : unit.find_first_not_of(' '));
  const auto known = kUnits.find(unit.empty() ? "m" : unit);
  if (read.ec != std::errc() || known == kUnits.end()) {
    throw Error(Error::Kind::Option, "command line", option, typed, "a length as 8, 8m, 26.25ft, 315in or 8000mm");
  }
  return value * known->second;
}

AnalysisOptions analysisOptions(const TypedAnalysis& typed) {
  AnalysisOptions options;
  if (!typed.height.empty()) options.facts.height = lengthFrom("--height", typed.height);
  options.facts.yield = typed.yield_mpa.value_or(kUnknown);
  options.facts.modulus = typed.modulus_mpa.value_or(kUnknown);
  options.facts.roof = typed.roof;
  options.facts.foundation = typed.foundation;
  for (const Service service : {Service::New, Service::Rebuilt, Service::InService}) {
    if (typed.service == nameOf(service)) options.facts.service = service;
  }
  options.classic_points = typed.classic_points;
  options.limits_file = typed.limits;
  if (!typed.limits.empty()) options.limits = readLimits(typed.limits);
  return options;
}

}  // namespace tank_datum
