#pragma once

#include <string>
#include <vector>

#include "limits/limit_tables.h"
#include "tank_datum/limits/limits.h"

namespace tank_datum {

/// Every limit beside the figure it is for; rows of a table (one code, clause and name) make one check.
/// A failure needs the whole 95 % interval beyond the limit; a pass value and interval within it, and that no gap hides
/// a part of the ring.
/// Where the diameter's error leaves open which of two rows is for the tank, the stricter is shown, and a verdict that
/// is not that of both is undecided.
std::vector<Check> judge(const std::vector<Limit>& limits, const std::vector<Measure>& measures, const TankFacts& facts,
                         const Diameter& diameter);

/// A figure beside the first limit for its quantity and such a tank, of a rule for tanks of its service if there is
/// one. That of another service judges nothing.
LimitComparison compare(const std::vector<Limit>& limits, const Measure& measure, const TankFacts& facts,
                        const Diameter& diameter);

/// What of a ring was measured.
struct RingSurveyed {
  bool dense;  ///< more than 64 stations: the regression's curvature governs out-of-plane settlement; else Andreani's
               ///< arcs, or where those cannot be judged the classic rule (ballot B.2.2.5 to B.2.2.8)
  bool whole;  ///< no gap that could hide a part of its shape, and nothing refused that may be the datum
};

/// Gives the checks their roles.
Headline headlineOf(std::vector<Check>& checks, const RingSurveyed& ring);

/// "107 % of its limit (95 %: 106 to 118 %)"
std::string shareOfLimit(const Headline& headline);

}  // namespace tank_datum
