#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tank_datum/core/error.h"
#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/limits/verdict.h"
#include "tank_datum/stations/placed_value.h"

namespace TANK_DATUM_API tank_datum {

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

/// Every limit beside the figure it is for; rows of a table (one code, clause and name) make one check.
/// A failure needs the whole 95 % interval beyond the limit; a pass value and interval within it, and that no gap hides
/// a part of the ring.
/// @param diameter  of the tank [m]
std::vector<Check> judge(const std::vector<Limit>& limits, const std::vector<Measure>& measures, const TankFacts& facts,
                         double diameter);

/// What all checks that count come to: those that are judged, are of the tank's service and are no second opinion.
struct Headline {
  std::string word =
      "INCOMPLETE";       ///< FAIL if one fails, else UNDECIDED, else INCOMPLETE if one is not evaluated, else PASS
  std::string governing;  ///< the check that says so, or comes nearest to its limit
  double utilisation = kUnknown;  ///< its value over its limit
  std::string sentence;
};

/// @param dense  more than 64 measured stations: the regression's curvature governs out-of-plane settlement; else
///               Andreani's arcs, or where those cannot be judged the classic rule (ballot B.2.2.5 to B.2.2.8).
///               Gives the checks their roles.
Headline headlineOf(std::vector<Check>& checks, bool dense);

}  // namespace tank_datum
