#include "tank_datum/limits/limits.h"

namespace tank_datum {

const char* nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return "pass";
    case Verdict::Fail:
      return "fail";
    case Verdict::Undecided:
      return "undecided";
    case Verdict::NotApplicable:
      return "not_applicable";
    case Verdict::NotEvaluated:
      return "not_evaluated";
  }
  return "";
}

}  // namespace tank_datum
