#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A limit written as a product, such as "5.5 * L^2 * Y / E / H".
struct LimitFormula {
  double factor = 0.0;
  std::map<char, int> powers;  ///< of the letters D H Y E L S

  /// The value when every letter is given [metres and megapascals].
  std::optional<double> at(const std::map<char, double>& given) const;
};

/// The diameters a limit is for, written as an interval: "[12,45)", "(15.24,24.384]", "[75,)"; empty for all.
struct DiameterRange {
  double from = 0.0, to = std::numeric_limits<double>::infinity();
  bool with_from = true, with_to = false;

  bool holds(double diameter) const;
};

/// One row of the file of limits.
struct Limit {
  std::string code, clause, name;  ///< rows that share them are one table
  std::string quantity;            ///< what is judged, by the name in knownQuantities()
  bool judged = true;              ///< false: shown beside another limit
  LimitFormula formula;
  double at_most = std::numeric_limits<double>::infinity();  ///< cap of the formula
  std::string unit;                                          ///< of the limit: m, m/m, 1/m
  DiameterRange diameter;                                    ///< [m]
  std::string roof;                                          ///< open, fixed, or empty for both
  std::string foundation;                                    ///< ringwall, earth, or empty for both
  std::string service;                                       ///< new, rebuilt, in-service, or empty for all
  std::string trust;                                         ///< verified, secondary, unverified
  std::string citation;
};

/// The quantities a limit can be for.
const std::vector<std::string>& knownQuantities();

/// The limits that come with the library, as the text of their file: to be read, copied and changed.
const std::string& standardLimitsText();
const std::vector<Limit>& standardLimits();

/// Limits from the text of such a file.
/// @param file  its name, for messages
/// @throws Error (Option) naming file, line and what is wrong
std::vector<Limit> parseLimits(const std::string& text, const std::string& file);

/// @throws Error (File) the file cannot be read; Error (Option) as parseLimits
std::vector<Limit> readLimits(const std::string& path);

}  // namespace tank_datum
