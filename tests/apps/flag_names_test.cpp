#include "flag_names.h"

#include <gtest/gtest.h>

namespace tank_datum::flag_names_test {

TEST(FlagNames, AnOptionOfATextBecomesItsFlag) {
  EXPECT_EQ(flagOf("setup_error"), "--setup-error");
  EXPECT_EQ(withFlags("doubtful (option accept takes it): no"), "doubtful (--accept takes it): no");
  EXPECT_EQ(withFlags("option yield_mpa, option roof: open or fixed"), "--yield-mpa, --roof: open or fixed");
  EXPECT_EQ(withFlags("an option that is none, adoption k"), "an option that is none, adoption k");
  EXPECT_EQ(withFlags("option locate.min_arc_deg"), "option locate.min_arc_deg");  // of C++ alone
  EXPECT_EQ(withFlags(""), "");
}

TEST(FlagNames, ARefusedOptionIsNamedByItsFlag) {
  const auto line = [](const std::string& name, const std::string& value, const std::string& expected) {
    return lineOf(Error(Error::Kind::Option, "options", {name, value, expected}));
  };
  EXPECT_EQ(line("angle_deg", "95", "> 0 and < 90 deg"), "options: --angle-deg, 95, expected > 0 and < 90 deg");
  EXPECT_EQ(line("locate.min_arc_deg", "-1", "> 0"), "options: locate.min_arc_deg, -1, expected > 0");
  EXPECT_EQ(line("radius of option tank", "5 m", "6 m"), "options: radius of --tank, 5 m, expected 6 m");
}

TEST(FlagNames, WhatTheUserTypedStaysAsItIs) {
  const std::string name = "option k = 2 (must be >= 3).pcd";
  const Error file(Error::Kind::File, "io", {"POINTS of " + name, "-5", "a whole number"});
  EXPECT_EQ(lineOf(file), "io: POINTS of " + name + ", -5, expected a whole number");
  const Error option(Error::Kind::Option, "movement", {"baseline", name, "a result"});
  EXPECT_EQ(lineOf(option), "movement: --baseline, " + name + ", expected a result");
}

}  // namespace tank_datum::flag_names_test
