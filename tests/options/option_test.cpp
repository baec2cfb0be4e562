#include "options/option.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/refused.h"

namespace tank_datum::option_test {

constexpr double kRightAngle = 1.5707963267948966;

Option of(OptionValue value, Unit unit = Unit::None, const Bounds& bounds = {}) {
  Option option{"it", "", std::move(value), "how far; 0: as it is", "", unit, bounds, Giver::All, 0, false, true};
  return option;
}

std::string said(const Option& option) { return said(option.refused()); }

TEST(Bounds, SayWhatTheyHold) {
  const Bounds all[] = {{},
                        atLeast(3),
                        above(0),
                        within(8, 360),
                        aboveUpTo(0, 100),
                        {0, 90, true, true},
                        {0, 1, false, true},
                        {4, 1000, false, false, true}};
  const char* const texts[] = {"finite",         ">= 3",         "> 0",          "8 to 360",
                               "> 0 and <= 100", "> 0 and < 90", ">= 0 and < 1", "0 or 4 to 1000"};
  for (std::size_t i = 0; i < std::size(texts); ++i) EXPECT_EQ(all[i].text(), texts[i]);
}

TEST(Bounds, HoldTheirEndsUnlessTheySayNot) {
  EXPECT_TRUE(atLeast(3).hold(3));
  EXPECT_FALSE(atLeast(3).hold(2.999));
  EXPECT_FALSE(above(0).hold(0));
  EXPECT_TRUE(aboveUpTo(0, 100).hold(100));
  EXPECT_FALSE(aboveUpTo(0, 100).hold(100.001));
  EXPECT_FALSE((Bounds{0, 90, true, true}.hold(90)));
  EXPECT_TRUE((Bounds{4, 1000, false, false, true}.hold(0)));
  EXPECT_FALSE((Bounds{4, 1000, false, false, true}.hold(3)));
  EXPECT_FALSE(Bounds{}.hold(NAN));
  EXPECT_FALSE(Bounds{}.hold(INFINITY));
}

TEST(Option, NumbersAreInTheUnitThatPeopleType) {
  double angle = kRightAngle;
  const Option degrees = of(&angle, Unit::Degrees, {0, 90, true, true});
  EXPECT_EQ(degrees.typed(angle), 90.0);
  EXPECT_NEAR(degrees.kept(45.0), 0.5 * kRightAngle, 1e-15);
  EXPECT_EQ(said(degrees), "it, 90, expected > 0 and < 90 deg");
  EXPECT_NEAR(of(&angle, Unit::ArcSeconds).typed(kRightAngle / 90.0), 3600.0, 1e-9);
  EXPECT_NEAR(of(&angle, Unit::ArcSeconds).kept(3600.0), kRightAngle / 90.0, 1e-15);
  EXPECT_EQ(of(&angle, Unit::Metres).kept(3.0), 3.0);
}

TEST(Option, HelpHasItsUnit) {
  double value = 1.0;
  EXPECT_EQ(of(&value).text(), "how far; 0: as it is");
  EXPECT_EQ(of(&value, Unit::Metres).text(), "how far [m]; 0: as it is");
  EXPECT_EQ(of(&value, Unit::Degrees).text(), "how far; 0: as it is");  // its name ends in _deg
  EXPECT_EQ(of(Fact{&value}, Unit::Megapascals).text(), "how far [MPa]; 0: as it is");
  EXPECT_EQ(of(Fact{&value}, Unit::Metres).text(), "how far; 0: as it is");  // typed with its unit
}

TEST(Option, AFactMayBeUnknownAndANumberNot) {
  double value = NAN;
  EXPECT_EQ(said(of(Fact{&value}, Unit::Megapascals, above(50))), "");
  EXPECT_EQ(said(of(&value, Unit::Metres, above(0))), "it, nan, expected > 0 m");
  value = 50.0;
  EXPECT_EQ(said(of(Fact{&value}, Unit::Megapascals, above(50))), "it, 50, expected > 50 MPa");
}

TEST(Option, NumbersRise) {
  std::vector<double> values{0.3, 0.3};
  EXPECT_EQ(said(of(&values, Unit::Metres, above(0))), "it, 0.3, expected > 0 m and above the one before");
  values = {0.3, 0.4};
  EXPECT_EQ(said(of(&values, Unit::Metres, above(0))), "");
}

TEST(Option, ACircleIsFiniteAndHasARadius) {
  std::optional<Circle> circle;
  const Option option = of(&circle, Unit::Metres, above(0));
  EXPECT_EQ(said(option), "");
  circle = Circle{{1.0, 2.0}, 3.0};
  EXPECT_EQ(said(option), "");
  circle = Circle{{1.0, 2.0}, -3.0};
  EXPECT_EQ(said(option), "it, 1,2,-3, expected X,Y,R, of which R > 0 m");
  circle = Circle{{1.0, NAN}, 3.0};
  EXPECT_EQ(said(option), "it, 1,nan,3, expected X,Y,R, of which R > 0 m");
}

TEST(Option, AChoiceIsOneOfItsWords) {
  std::string word = "fixed";
  Choice choice;
  choice.words = {"open", "fixed", "none"};
  choice.get = [&word] { return word; };
  choice.set = [&word](const std::string& one) { word = one; };
  Option option = of(choice);
  option.choose("open");
  EXPECT_EQ(word, "open");
  EXPECT_THROW(option.choose("dome"), Error);
  EXPECT_THROW(option.choose(""), Error);
  word = "dome = 3 (must be round).csv";  // words of the user's own are not taken apart
  EXPECT_EQ(said(option), "it, dome = 3 (must be round).csv, expected open, fixed or none");
  choice.needed = false;
  option.value = choice;
  option.choose("");
  EXPECT_EQ(said(option), "");
}

}  // namespace tank_datum::option_test
