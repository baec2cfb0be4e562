#include <gtest/gtest.h>

#include "limits/checks.h"

namespace tank_datum::diameter_class_test {

const std::string kHeader =
    "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation\n";

std::vector<Limit> limits(const std::string& rows) { return parseLimits(kHeader + rows, "test"); }

Measure measure(const char* quantity, double value, double sigma) {
  Measure m;
  m.quantity = quantity;
  m.worst = {value, sigma, 1.5};
  return m;
}

const std::string kClasses =
    "A,1,radius,roundness_foot,judge,0.013,,m,\"(0,12)\",,,verified,c\n"
    "A,1,radius,roundness_foot,judge,0.019,,m,\"[12,45)\",,,verified,c\n";

/// A radius beside the limits of two classes, of a tank whose diameter [m] has this standard error.
Check ofClass(double radius, double diameter, double sigma) {
  return judge(limits(kClasses), {measure("roundness_foot", radius, 0.0005)}, {}, {diameter, sigma}).at(0);
}

TEST(Judge, ByTheStricterOfTwoLimitsWhereTheDiameterIsOfEitherClass) {
  EXPECT_EQ(ofClass(0.016, 11.999, 0.0).verdict, Verdict::Fail);
  EXPECT_EQ(ofClass(0.016, 12.001, 0.0).verdict, Verdict::Pass);
  for (const double diameter : {11.999, 12.001}) {
    const Check open = ofClass(0.016, diameter, 0.001);
    EXPECT_EQ(open.verdict, Verdict::Undecided) << diameter;
    EXPECT_EQ(open.limit, 0.013) << diameter;
    EXPECT_NE(open.note.find("either of two classes"), std::string::npos);
    EXPECT_EQ(ofClass(0.016, diameter, 0.0005).note.find("either"), std::string::npos) << "1.96 of its errors away";
    EXPECT_EQ(ofClass(0.010, diameter, 0.001).verdict, Verdict::Pass);
    EXPECT_EQ(ofClass(0.025, diameter, 0.001).verdict, Verdict::Fail);
  }
}

TEST(Judge, AClassWithoutALimitLeavesThatOfTheOther) {
  const std::string only = "A,1,radius,roundness_foot,judge,0.013,,m,\"(0,12)\",,,verified,c\n";
  const auto verdict = [&](double sigma) {
    return judge(limits(only), {measure("roundness_foot", 0.016, 0.0005)}, {}, {12.001, sigma}).at(0).verdict;
  };
  EXPECT_EQ(verdict(0.0), Verdict::NotApplicable);
  EXPECT_EQ(verdict(0.001), Verdict::Undecided);
}

/// The tank's own rule first, wherever it stands in the file.
TEST(Compare, PrefersTheRuleOfTheTanksService) {
  const std::vector<Limit> rules = parseLimits(
      "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation,service\n"
      "A,1,radius,roundness_foot,judge,0.013,,m,,,,verified,c,new\n"
      "B,1,radius,roundness_foot,judge,0.060,,m,,,,verified,c,rebuilt\n",
      "test");
  TankFacts facts;
  facts.service = Service::Rebuilt;
  const LimitComparison own = compare(rules, measure("roundness_foot", 0.02, 0.001), facts, {20.0});
  EXPECT_EQ(own.limit, 0.060);
  EXPECT_EQ(own.verdict, Verdict::Pass);
  EXPECT_EQ(own.service, "");
}

}  // namespace tank_datum::diameter_class_test
