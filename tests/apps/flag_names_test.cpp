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

TEST(FlagNames, AFileIsNamedWhereItWillBe) {
  const auto line = [](const std::string& name) {
    return lineOf(Error(Error::Kind::File, "report", {name, "No space left on device", "room"}));
  };
  EXPECT_EQ(line("out/.tank_datum-12-0/new/datum.json"),
            "report: out/datum.json, No space left on device, expected room");
  EXPECT_EQ(line("writing of /a/.tank_datum-12-1/new/c.pcd"),
            "report: writing of /a/c.pcd, No space left on device, expected room");
  EXPECT_EQ(line("out/.tank_datum-commit/journal.json.part"), "report: out, No space left on device, expected room");
  EXPECT_EQ(line("out/.tank_datum-commit"), "report: out, No space left on device, expected room");
}

TEST(FlagNames, AnOverlongValueIsCut) {
  const auto line = [](const std::string& value) {
    return lineOf(Error(Error::Kind::Option, "options", {"k", value, ">= 3"}));
  };
  EXPECT_EQ(line(std::string(5000, '7')), "options: --k, " + std::string(60, '7') + "..., expected >= 3");
  EXPECT_EQ(line("in " + std::string(61, '7') + " m"),
            "options: --k, in " + std::string(60, '7') + "... m, expected >= 3");
  EXPECT_EQ(line(std::string(59, '7') + "\xc3\xa9"), "options: --k, " + std::string(59, '7') + "..., expected >= 3");
  const std::string path = "/" + std::string(200, 'p') + "/scan.pcd", words = "a value of many words, " + path;
  EXPECT_EQ(line(words), "options: --k, " + words + ", expected >= 3");
}

}  // namespace tank_datum::flag_names_test
