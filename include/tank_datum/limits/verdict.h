#pragma once

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// How a figure stands to its limit.
enum class Verdict {
  Pass,
  Fail,
  Undecided,      ///< the limit lies within the 95 % interval, or what was not seen could be worse
  NotApplicable,  ///< the rule is not for such a tank, such a survey or its service; or it is only shown
  NotEvaluated,   ///< the rule is for it, but something it needs was not given or not surveyed
};

/// The names used in files: "pass", "fail", "undecided", "not_applicable", "not_evaluated".
const char* nameOf(Verdict verdict);

}  // namespace tank_datum
