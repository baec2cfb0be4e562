#include <gtest/gtest.h>

#include "limits/checks.h"

namespace tank_datum::headline_test {

Check named(const char* quantity, Verdict verdict, double share, const char* role = "judged") {
  Check check;
  check.quantity = check.name = quantity;
  check.code = "A";
  check.verdict = verdict;
  check.role = role;
  check.value = share, check.limit = 1.0;
  return check;
}

TEST(HeadlineOf, TheGoverningRuleAndNotTheSecondOpinions) {
  std::vector<Check> checks = {named("second_difference", Verdict::Fail, 1.5), named("curvature", Verdict::Pass, 0.6),
                               named("settlement_arc", Verdict::Undecided, 1.0)};
  const Headline dense = headlineOf(checks, {true, true});
  EXPECT_EQ(dense.word, "PASS");
  EXPECT_EQ(dense.governing, "A curvature");
  EXPECT_EQ(dense.utilisation, 0.6);
  EXPECT_EQ(checks[0].role, "second opinion");
  EXPECT_EQ(checks[1].role, "governing");
  for (Check& c : checks) c.role = "judged";
  EXPECT_EQ(headlineOf(checks, {false, true}).word, "UNDECIDED");
  for (Check& c : checks) c.role = "judged";
  checks[2].verdict = Verdict::NotEvaluated;
  EXPECT_EQ(headlineOf(checks, {false, true}).word, "FAIL");  // the classic rule where arcs cannot be judged
}

TEST(HeadlineOf, WorstOfWhatCounts) {
  std::vector<Check> checks = {named("tilt_height", Verdict::Pass, 0.5)};
  EXPECT_EQ(headlineOf(checks, {true, true}).word, "PASS");
  checks.push_back(named("slope_10m", Verdict::NotEvaluated, 0.2));
  EXPECT_EQ(headlineOf(checks, {true, true}).word, "INCOMPLETE");
  checks.push_back(named("neighbour_slope", Verdict::Undecided, 0.9));
  EXPECT_EQ(headlineOf(checks, {true, true}).word, "UNDECIDED");
  checks.push_back(named("neighbour_bend", Verdict::Fail, 1.3));
  EXPECT_EQ(headlineOf(checks, {true, true}).word, "FAIL");
  EXPECT_NE(headlineOf(checks, {true, true}).sentence.find("130 % of its limit"), std::string::npos);
  checks = {named("level_9m", Verdict::NotApplicable, 3.0, "for comparison")};
  EXPECT_EQ(headlineOf(checks, {true, true}).word, "INCOMPLETE");
  EXPECT_EQ(headlineOf(checks, {true, true}).governing, "");
}

TEST(HeadlineOf, AShareIsShownOnItsOwnSideOfTheLimit) {
  for (const auto& [value, shown] : {std::pair(0.994, "99 %"),
                                     {0.996, "99.60 %"},
                                     {0.99999, "99.99 %"},
                                     {1.0, "100 %"},
                                     {1.0023, "100.23 %"},
                                     {1.006, "101 %"}}) {
    std::vector<Check> checks = {named("tilt_height", value < 1.0 ? Verdict::Pass : Verdict::Undecided, value)};
    EXPECT_EQ(shareOfLimit(headlineOf(checks, {true, true})), std::string(shown) + " of its limit");
  }
}

TEST(HeadlineOf, SaysHowSureItIs) {
  struct Said {
    Verdict verdict;
    double value;
    Interval95 interval;
    const char* meaning;
  };
  for (const Said& said : {Said{Verdict::Fail, 1.2, {1.1, 1.3}, ", beyond it with 95 % confidence"},
                           Said{Verdict::Fail, 1.2, {}, ", beyond it; errors are not known"},
                           Said{Verdict::Pass, 0.2, {0.1, 0.3}, ", the nearest of all"},
                           Said{Verdict::Pass, 0.2, {}, ", the nearest of all; errors are not known"},
                           Said{Verdict::Undecided, 0.9, {0.8, 1.1}, ", too near it to decide"},
                           Said{Verdict::Undecided, 1.1, {0.8, 0.9}, ", too near it to decide"},
                           Said{Verdict::Undecided, 0.01, {0.0, 0.26}, "; what was not measured could be worse"},
                           Said{Verdict::NotEvaluated, 0.01, {0.0, 0.26}, " is not evaluated: not given"}}) {
    std::vector<Check> checks = {named("tilt_height", said.verdict, said.value)};
    checks[0].note = "not given";
    checks[0].interval = said.interval;
    const Headline headline = headlineOf(checks, {true, true});
    EXPECT_EQ(headline.meaning, said.meaning);
    EXPECT_NE(headline.sentence.find(said.meaning), std::string::npos) << headline.sentence;
  }
}

/// Errors widen an interval to both sides, what was not measured upwards only.
TEST(HeadlineOf, AFigureFarFromItsLimitIsNotNearIt) {
  const auto meaning = [](double value, Interval95 interval, bool whole) {
    std::vector<Check> checks = {named("tilt_height", Verdict::Undecided, value)};
    checks[0].interval = interval;
    return headlineOf(checks, {true, whole}).meaning;
  };
  EXPECT_EQ(meaning(0.7, {0.65, 1.7}, false), "; what was not measured could be worse");
  EXPECT_EQ(meaning(0.7, {0.39, 1.7}, false), ", too near it to decide");
  EXPECT_EQ(meaning(0.7, {0.65, 1.7}, true), ", too near it to decide");
  EXPECT_EQ(meaning(1.01, {0.99, 1.7}, false), ", too near it to decide");
}

}  // namespace tank_datum::headline_test
