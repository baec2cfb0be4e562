#include "tank_datum/limits/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "limits/limit_formula.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"

namespace tank_datum::limits_test {

const std::string kHeader =
    "code,clause,name,quantity,use,formula,at_most,unit,diameter,roof,foundation,trust,citation\n";

std::string refusal(const std::string& row) {
  return refusalOf(Error::Kind::Option, [&] { parseLimits(kHeader + row, "mine.csv"); });
}

TEST(ParseFormula, ProductsAndPowers) {
  const std::map<char, double> given = {{'D', 60}, {'H', 16}, {'Y', 235}, {'E', 206000}, {'L', 6.096}};
  const auto value = [&](const char* text) { return parseFormula(text)->at(given).value(); };
  EXPECT_DOUBLE_EQ(value("0.004 * D"), 0.24);
  EXPECT_DOUBLE_EQ(value("1/200"), 0.005);
  EXPECT_DOUBLE_EQ(value(" L^2 / H"), 6.096 * 6.096 / 16);
  EXPECT_DOUBLE_EQ(value("D ^ -1"), 1.0 / 60);
  EXPECT_FALSE(parseFormula("2 * S")->at(given).has_value());
}

TEST(ParseFormula, AllowableSecondDifferences) {  // STANDARDS 4.4 and 4.1
  const auto formula = *parseFormula("5.5 * L^2 * Y / E / H");
  const auto limit = [&](double spacing) {
    return 1e3 * formula.at({{'L', spacing}, {'H', 16}, {'Y', 235}, {'E', 206000}}).value();
  };
  EXPECT_NEAR(limit(6.096), 14.6, 0.05);
  EXPECT_NEAR(limit(3.14159265 * 60 / 360), 0.108, 0.0005);
}

TEST(ParseFormula, RefusesWhatIsNoProduct) {
  for (const char* text : {"", "D + 1", "2 *", "* 2", "x", "-1", "0", "D^", "1 2", "(D)", "1e999", "D^1.5"}) {
    EXPECT_FALSE(parseFormula(text).has_value()) << text;
  }
}

TEST(StandardLimits, AreWhatStandardsSay) {
  const auto& limits = standardLimits();
  EXPECT_GT(limits.size(), 30U);
  for (const std::string& quantity : knownQuantities()) {
    if (quantity == "top_ovality") continue;  // no code limits it: a rim seal's room does
    EXPECT_TRUE(std::any_of(limits.begin(), limits.end(), [&](const Limit& l) { return l.quantity == quantity; }))
        << quantity;
  }
  const auto find = [&](const char* quantity, double diameter, const char* roof) {
    return *std::find_if(limits.begin(), limits.end(), [&](const Limit& l) {
      return l.quantity == quantity && l.diameter.holds(diameter) && (l.roof.empty() || l.roof == roof);
    });
  };
  EXPECT_DOUBLE_EQ(find("tilt_height", 30, "open").formula.at({{'D', 30}}).value(), 0.18);
  EXPECT_DOUBLE_EQ(find("tilt_height", 30.1, "open").formula.at({{'D', 30.1}}).value(), 0.1505);
  EXPECT_EQ(find("tilt_height", 30.1, "open").trust, "unverified");
  EXPECT_DOUBLE_EQ(find("roundness_foot", 45, "").formula.at({}).value(), 0.025);
  EXPECT_DOUBLE_EQ(find("roundness_foot", 44.9, "").formula.at({}).value(), 0.019);
  EXPECT_NEAR(find("settlement_arc", 36.576, "open").formula.factor, 0.08333 * 6.5, 1e-12);
  EXPECT_EQ(find("settlement_arc", 30, "fixed").at_most, 0.1016);
  EXPECT_FALSE(find("curvature", 60, "").formula.powers.empty());
}

TEST(ParseLimits, ReadsEveryColumn) {
  const auto limits = parseLimits(
      kHeader + "Works,3.2,own rule,curvature,show,2 * Y / E,0.5,1/m,\"[10,20)\",fixed,earth,secondary,page 4\n",
      "mine");
  ASSERT_EQ(limits.size(), 1U);
  const Limit& l = limits[0];
  EXPECT_EQ(l.code + l.clause + l.name, "Works3.2own rule");
  EXPECT_FALSE(l.judged);
  EXPECT_EQ(l.at_most, 0.5);
  EXPECT_TRUE(l.diameter.holds(10) && !l.diameter.holds(20));
  EXPECT_EQ(l.roof + l.foundation + l.trust + l.citation + l.unit, "fixedearthsecondarypage 41/m");
}

TEST(ParseLimits, RefusesWithLineAndReason) {
  const std::string good = "A,1,n,curvature,judge,1,,1/m,,,,verified,c\n";
  EXPECT_EQ(refusal(good), "");
  EXPECT_EQ(refusal(good + "A,1\n"), "limits: mine.csv line 3, 2 cells, expected 13 or 14");
  EXPECT_NE(refusal("A,1,n,bend,judge,1,,1/m,,,,verified,c\n").find("mine.csv line 2 quantity, \"bend\""),
            std::string::npos);
  const std::pair<const char*, const char*> wrong[] = {
      {",1,n,curvature,judge,1,,1/m,,,,verified,c", "code"},
      {"A,1,n,curvature,maybe,1,,1/m,,,,verified,c", "use"},
      {"A,1,n,curvature,judge,D+1,,1/m,,,,verified,c", "formula"},
      {"A,1,n,curvature,judge,1,x,1/m,,,,verified,c", "at_most"},
      {"A,1,n,curvature,judge,1,,mm,,,,verified,c", "unit"},
      {"A,1,n,curvature,judge,1,,1/m,5-6,,,verified,c", "diameter"},
      {"A,1,n,curvature,judge,1,,1/m,\"[6,5]\",,,verified,c", "diameter"},
      {"A,1,n,curvature,judge,1,,1/m,,dome,,verified,c", "roof"},
      {"A,1,n,curvature,judge,1,,1/m,,,sand,verified,c", "foundation"},
      {"A,1,n,curvature,judge,1,,1/m,,,,sure,c", "trust"},
      {"A,1,n,curvature,judge,1,,1/m,,,,verified,", "citation"}};
  for (const auto& [row, column] : wrong) {
    EXPECT_NE(refusal(row).find(std::string("mine.csv line 2 ") + column + ","), std::string::npos) << row;
  }
}

TEST(ParseLimits, RefusesAnotherTable) {
  EXPECT_THROW(parseLimits("", "mine"), Error);
  EXPECT_THROW(parseLimits("a,b\n1,2\n", "mine"), Error);
  EXPECT_THROW(parseLimits(kHeader, "mine"), Error);
}

}  // namespace tank_datum::limits_test
