#include "trust/tank_tests.h"

#include <algorithm>

#include "core/clauses.h"

namespace tank_datum {

const char* nameOf(TestOutcome outcome) {
  switch (outcome) {
    case TestOutcome::Pass:
      return "pass";
    case TestOutcome::Doubtful:
      return "doubtful";
    case TestOutcome::Fail:
      return "fail";
  }
  return "";
}

TestOutcome worstOf(const std::vector<TankTest>& tests) {
  TestOutcome worst = TestOutcome::Pass;
  for (const TankTest& test : tests) worst = std::max(worst, test.outcome);
  return worst;
}

std::string findingsOf(const std::vector<TankTest>& tests) {
  const TestOutcome worst = worstOf(tests);
  std::string findings;
  for (const TankTest& test : tests) {
    if (worst == TestOutcome::Pass || test.outcome != worst) continue;
    addClause(findings, test.finding);
  }
  return findings;
}

}  // namespace tank_datum
