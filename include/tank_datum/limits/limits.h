#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

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

/// How a figure stands to its limit.
enum class Verdict {
  Pass,
  Fail,
  Undecided,      ///< the limit lies within the 95 % interval, or what was not measured could be worse
  NotApplicable,  ///< the rule is not for such a tank, such a survey or its service; or it is only shown
  NotEvaluated,   ///< the rule is for it, but something it needs was not given or not surveyed
};

/// The names used in files: "pass", "fail", "undecided", "not_applicable", "not_evaluated".
const char* nameOf(Verdict verdict);

/// Whose rules a tank is judged by.
enum class Service {
  New,        ///< at construction or after releveling (API 650 7.5)
  Rebuilt,    ///< reconstructed (API 653 section 10)
  InService,  ///< API 653 Annex B, EEMUA 159, DeBeer, GB 50473
};

/// The names used at the command line and in files: "new", "rebuilt", "in-service".
const char* nameOf(Service service);

/// What is known of the tank beside the scan; NaN or empty when not given.
struct TankFacts {
  double height = kUnknown;   ///< of the shell, H, at most 100 [m]
  double yield = kUnknown;    ///< yield strength of its steel, Y, 50 to 2000 [MPa]
  double modulus = kUnknown;  ///< its elastic modulus, E, 5e4 to 5e5 [MPa]
  std::string roof;           ///< "open" (floating roof) or "fixed"
  std::string foundation;     ///< "ringwall" or "earth"
  Service service = Service::InService;
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const TankFacts& facts);

/// A figure that the file of limits may judge.
struct Measure {
  std::string quantity;       ///< one of knownQuantities()
  PlacedValue worst;          ///< unknown when it could not be had
  Interval95 interval;        ///< of the largest, where errors are known; else worst.sigma gives it
  double freedom = 0.0;       ///< degrees of freedom behind worst.sigma; 0: normal
  double spacing = kUnknown;  ///< of survey points, L [m]
  double arc = kUnknown;      ///< length of the settlement arc, S [m]
  /// 95 % interval of the largest value over the limit for its arc, where the limit goes with it.
  std::function<Interval95(const std::function<double(double arc)>& limit)> share;
  std::vector<PlacedValue> all;  ///< every value of which `worst` is the largest, where their share matters
  std::string note;              ///< what a reader should know of it
  std::string unavailable;       ///< why it could not be had
  bool whole_ring = true;        ///< false: a gap too wide to say there is nothing worse in it
};

/// A figure beside its limit.
struct Check {
  std::string code, clause, name;
  std::string quantity;                       ///< what is judged
  double value = kUnknown, sigma = kUnknown;  ///< in `unit`; sigma is its standard error
  double limit = kUnknown;                    ///< unknown when something for it is not given
  Interval95 interval;                        ///< 95 %: of the largest of all places, not of the worst one alone
  double azimuth = kUnknown;                  ///< of the worst place [rad]
  std::string unit;
  Verdict verdict = Verdict::NotApplicable;
  /// What part it plays: "judged", "governing" of the rules on out-of-plane settlement, "second opinion" beside that,
  /// "shown" beside another limit, "for comparison" as a rule of another service.
  std::string role;
  std::string trust;     ///< how far the rule's numbers are trusted: verified, secondary, unverified
  std::string note;      ///< why not, or what to know of it
  std::string citation;  ///< of the limit
};

/// A figure beside the limit for it, whoever the rule is for.
struct LimitComparison {
  double limit = kUnknown;  ///< in the figure's unit; unknown when there is none for such a tank
  Verdict verdict = Verdict::NotEvaluated;
  std::string service{};  ///< that the limit is for, where the tank's is another: then it judges nothing
};

/// What all checks that count come to: those that are judged, are of the tank's service and are no second opinion.
struct Headline {
  std::string word =
      "INCOMPLETE";       ///< FAIL if one fails, else UNDECIDED, else INCOMPLETE if one is not evaluated, else PASS
  std::string governing;  ///< the check that says so, or comes nearest to its limit
  double utilisation = kUnknown;    ///< its value over its limit
  Interval95 utilisation_interval;  ///< 95 % interval of that
  std::string meaning;              ///< how sure the word is, or what is missing
  std::string sentence;             ///< all of it
};

}  // namespace tank_datum
