#include "limits/checks.h"

#include <gtest/gtest.h>

#include "support/refused.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::checks_test {

const std::string kHeader =
    "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation\n";

std::vector<Limit> limits(const std::string& rows) { return parseLimits(kHeader + rows, "test"); }

Measure measure(const char* quantity, double value, double sigma) {
  Measure m;
  m.quantity = quantity;
  m.worst = {value, sigma, 1.5};
  return m;
}

Check one(const std::string& rows, const std::vector<Measure>& measures, const TankFacts& facts = {}, double d = 20) {
  const auto checks = judge(limits(rows), measures, facts, {d});
  EXPECT_EQ(checks.size(), 1U);
  return checks.at(0);
}

const std::string kTilt = "A,1,tilt,tilt_slope,judge,0.01,,m/m,,,,verified,c\n";

TEST(Judge, ByTheNinetyFivePercentInterval) {
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0060, 0.002)}).verdict, Verdict::Pass);
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0062, 0.002)}).verdict, Verdict::Undecided);
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0138, 0.002)}).verdict, Verdict::Undecided);
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0140, 0.002)}).verdict, Verdict::Fail);
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0101, NAN)}).verdict, Verdict::Fail);
  EXPECT_EQ(one(kTilt, {measure("tilt_slope", 0.0099, NAN)}).verdict, Verdict::Pass);
}

TEST(Judge, NoSizeIsBelowZero) {
  const Check check = one(kTilt, {measure("tilt_slope", 0.001, 0.002)});
  EXPECT_EQ(check.interval.low, 0.0);
  EXPECT_NEAR(check.interval.high, 0.001 + 1.96 * 0.002, 1e-5);
}

/// A rule for new tanks judges no old one.
TEST(Compare, SaysForWhomTheRuleIs) {
  const std::vector<Limit> rule = parseLimits(
      "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation,service\n"
      "A,1,tilt,tilt_slope,judge,0.01,,m/m,,,,verified,c,new\n",
      "test");
  TankFacts facts;
  EXPECT_EQ(compare(rule, measure("tilt_slope", 0.02, 0.001), facts, {20.0}).service, "new");
  EXPECT_EQ(compare(rule, measure("tilt_slope", 0.02, 0.001), facts, {20.0}).verdict, Verdict::NotApplicable);
  facts.service = Service::New;
  EXPECT_EQ(compare(rule, measure("tilt_slope", 0.02, 0.001), facts, {20.0}).service, "");
  EXPECT_EQ(compare(rule, measure("tilt_slope", 0.02, 0.001), facts, {20.0}).verdict, Verdict::Fail);
}

TEST(Judge, AGapLeavesAPassUndecidedAndAFailAFail) {
  Measure m = measure("tilt_slope", 0.001, 0.0001);
  m.whole_ring = false;
  EXPECT_EQ(one(kTilt, {m}).verdict, Verdict::Undecided);
  EXPECT_NE(one(kTilt, {m}).note.find("what was not measured could be worse"), std::string::npos);
  m.worst.value = 0.02;
  EXPECT_EQ(one(kTilt, {m}).verdict, Verdict::Fail);
}

TEST(Judge, SaysWhatIsNotGiven) {
  const std::string rule = "A,1,curve,curvature,judge,11 * Y / E / H,,1/m,,,,verified,c\n";
  TankFacts facts;
  facts.height = 16;
  const Check check = one(rule, {measure("curvature", 1e-4, 1e-6)}, facts);
  EXPECT_EQ(check.verdict, Verdict::NotEvaluated);
  EXPECT_EQ(check.note, "not given: yield strength (option yield_mpa), elastic modulus (option modulus_mpa)");
  EXPECT_TRUE(std::isnan(check.limit));
  EXPECT_EQ(check.value, 1e-4);
  facts.yield = 235;
  facts.modulus = 206000;
  EXPECT_NEAR(one(rule, {measure("curvature", 1e-4, 1e-6)}, facts).limit, 7.843e-4, 1e-7);
  EXPECT_EQ(one(rule, {measure("curvature", 1e-4, 1e-6)}, facts).verdict, Verdict::Pass);
}

TEST(Judge, TakesTheRowForTheTank) {
  const std::string table =
      "A,1,t,tilt_height,judge,0.1,,m,\"(0,20]\",open,,verified,c\n"
      "A,1,t,tilt_height,judge,0.2,,m,\"(20,40]\",open,,secondary,c2\n"
      "A,1,t,tilt_height,judge,0.3,,m,\"(0,40]\",fixed,,unverified,c3\n";
  TankFacts open, fixed;
  open.roof = "open";
  fixed.roof = "fixed";
  const std::vector<Measure> m = {measure("tilt_height", 0.01, 0.001)};
  EXPECT_EQ(one(table, m, open, 20).limit, 0.1);
  EXPECT_EQ(one(table, m, open, 20.1).limit, 0.2);
  EXPECT_EQ(one(table, m, open, 20.1).trust, "secondary");
  EXPECT_EQ(one(table, m, fixed, 30).limit, 0.3);
  EXPECT_NE(one(table, m, {}, 30).note.find("option roof"), std::string::npos);
  EXPECT_EQ(one(table, m, open, 50).note, "the rule has no limit for such a tank");
  EXPECT_EQ(one(table, m, open, 50).verdict, Verdict::NotApplicable);
  const std::string wall = "A,1,l,level_total,judge,0.006,,m,,,ringwall,verified,c\n";
  EXPECT_NE(one(wall, {measure("level_total", 0.001, 0.0001)}).note.find("option foundation"), std::string::npos);
}

TEST(Judge, OfSeveralFiguresTheOneNearestItsLimit) {
  const std::string rule = "A,1,arc,settlement_arc,judge,0.001 * S,0.05,m,,,,verified,c\n";
  Measure large = measure("settlement_arc", 0.03, 0.001), small = measure("settlement_arc", 0.009, 0.0001);
  large.arc = 40;
  small.arc = 10;
  const Check check = one(rule, {large, small});
  EXPECT_EQ(check.value, 0.009);
  EXPECT_EQ(check.limit, 0.01);
  large.arc = 500;
  EXPECT_EQ(one(rule, {large}).limit, 0.05);
}

TEST(Judge, CountsTheShareBeyondTheLimit) {
  Measure m = measure("tilt_slope", 0.04, 0.0001);
  for (const double v : {0.001, 0.002, 0.02, 0.04}) m.all.push_back({v, 0.0001, 0.0});
  EXPECT_NE(one(kTilt, {m}).note.find("50 % of 4 values exceed the limit"), std::string::npos);
}

TEST(Judge, WhatIsShownIsNotJudged) {
  const Check check = one("A,1,t,tilt_slope,show,0.01,,m/m,,,,verified,c\n", {measure("tilt_slope", 0.5, 0.0)});
  EXPECT_EQ(check.verdict, Verdict::NotApplicable);
  EXPECT_EQ(check.limit, 0.01);
}

TEST(Judge, ByTheIntervalOfTheLargestWhereThereIsOne) {
  const auto with = [](double value, double low, double high) {
    Measure m = measure("tilt_slope", value, 0.0);
    m.interval = {low, high};
    return one(kTilt, {m});
  };
  EXPECT_EQ(with(0.012, 0.0101, 0.013).verdict, Verdict::Fail);
  EXPECT_EQ(with(0.012, 0.0099, 0.013).verdict, Verdict::Undecided);
  EXPECT_EQ(with(0.0095, 0.006, 0.0099).verdict, Verdict::Pass);
  EXPECT_EQ(with(0.0105, 0.006, 0.0099).verdict, Verdict::Undecided) << "no pass beyond the limit";
  EXPECT_NEAR(with(0.012, 0.010, 0.013).sigma, 0.002 / 1.959964, 1e-9);  // 95 % reach the further end
}

TEST(Judge, FewStationsHaveStudentsT) {
  Measure m = measure("tilt_slope", 0.0050, 0.0020);
  EXPECT_EQ(one(kTilt, {m}).verdict, Verdict::Pass);
  m.freedom = 5;  // 8 stations: 2.57 in place of 1.96
  EXPECT_EQ(one(kTilt, {m}).verdict, Verdict::Undecided);
}

TEST(Judge, OfArcsTheShareOfTheirOwnLimits) {
  const std::string rule = "A,1,arc,settlement_arc,judge,0.001 * S,0.05,m,,,,verified,c\n";
  Measure m = measure("settlement_arc", 0.012, 0.001);
  m.arc = 10;
  m.share = [](const std::function<double(double)>& limit) { return Interval95{0.0105 / limit(10), 0.02 / limit(10)}; };
  const Check check = one(rule, {m});
  EXPECT_NEAR(check.interval.low, 0.0105, 1e-12);
  EXPECT_EQ(check.verdict, Verdict::Fail);
}

TEST(Judge, ARuleOfAnotherServiceIsShownForComparison) {
  const std::string header =
      "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation,service\n";
  const auto rows = parseLimits(header + "A,1,tilt,tilt_slope,judge,0.01,,m/m,,,,verified,c,new\n", "test");
  TankFacts facts;
  const std::vector<Measure> measures = {measure("tilt_slope", 0.02, 0.001)};
  const Check compared = judge(rows, measures, facts, {20.0}).at(0);
  EXPECT_EQ(compared.verdict, Verdict::NotApplicable);
  EXPECT_EQ(compared.role, "for comparison");
  EXPECT_EQ(compared.limit, 0.01);
  facts.service = Service::New;
  EXPECT_EQ(judge(rows, measures, facts, {20.0}).at(0).verdict, Verdict::Fail);
}

TEST(Judge, AFigureAboveItsIntervalSaysWhy) {
  Measure m = measure("tilt_slope", 0.0050, 0.0001);
  EXPECT_EQ(one(kTilt, {m}).note.find("raise"), std::string::npos);
  m.interval = {0.0046, 0.0049};
  EXPECT_NE(one(kTilt, {m}).note.find("errors of the survey raise the figure above its interval"), std::string::npos);
}

TEST(Judge, AFigureBelowItsIntervalSaysWhy) {
  Measure m = measure("tilt_slope", 0.0050, 0.0001);
  EXPECT_EQ(one(kTilt, {m}).note.find("smooths"), std::string::npos);
  m.interval = {0.0051, 0.0054};
  EXPECT_NE(one(kTilt, {m}).note.find("the figure smooths local settlement that its interval holds"),
            std::string::npos);
}

TEST(Judge, WhatCouldNotBeHadIsNotApplicable) {
  EXPECT_EQ(one(kTilt, {}).note, "the survey does not hold it");
  Measure m = measure("tilt_slope", NAN, NAN);
  m.unavailable = "too few stations";
  EXPECT_EQ(one(kTilt, {m}).note, "too few stations");
  EXPECT_EQ(one(kTilt, {m}).verdict, Verdict::NotApplicable);
}

TEST(TankFacts, AreRefusedByName) {
  EXPECT_EQ(said(firstError(TankFacts{})), "");
  TankFacts facts;
  facts.height = -3;
  EXPECT_EQ(said(firstError(facts)), "height, -3, expected > 0 and <= 100 m");
  facts = {};
  facts.yield = 0;
  EXPECT_EQ(said(firstError(facts)), "yield_mpa, 0, expected > 50 and <= 2000 MPa");
  facts.yield = 36000;  // psi
  EXPECT_EQ(said(firstError(facts)), "yield_mpa, 36000, expected > 50 and <= 2000 MPa");
  facts = {};
  facts.modulus = INFINITY;
  EXPECT_EQ(said(firstError(facts)), "modulus_mpa, inf, expected > 50000 and <= 500000 MPa");
  facts.modulus = 206;  // GPa
  EXPECT_EQ(said(firstError(facts)), "modulus_mpa, 206, expected > 50000 and <= 500000 MPa");
  facts = {};
  facts.height = 16000;  // mm
  EXPECT_EQ(said(firstError(facts)), "height, 16000, expected > 0 and <= 100 m");
  facts = {};
  facts.roof = "dome";
  EXPECT_EQ(said(firstError(facts)), "roof, dome, expected open or fixed");
  facts = {};
  facts.foundation = "sand";
  EXPECT_EQ(said(firstError(facts)), "foundation, sand, expected ringwall or earth");
}

TEST(Verdict, HasTheNamesOfTheFiles) {
  EXPECT_STREQ(nameOf(Verdict::Pass), "pass");
  EXPECT_STREQ(nameOf(Verdict::Fail), "fail");
  EXPECT_STREQ(nameOf(Verdict::Undecided), "undecided");
}

}  // namespace tank_datum::checks_test
