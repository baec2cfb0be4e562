#include "options/option_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "options/option_json.h"
#include "support/refused.h"

namespace tank_datum::option_table_test {

/// Sets a number to just beyond an end of its bounds, whatever it is kept in.
struct Beyond {
  const Option& option;
  double value;

  bool operator()(int* kept) const { return *kept = static_cast<int>(value), value == *kept; }
  bool operator()(std::size_t* kept) const {
    if (value < 0.0) return false;
    return *kept = static_cast<std::size_t>(value), true;
  }
  bool operator()(double* kept) const { return *kept = option.kept(value), true; }
  bool operator()(const Fact& fact) const { return *fact.value = value, true; }
  template <typename Other>
  bool operator()(const Other&) const {
    return false;
  }
};

TEST(OptionTable, NamesAndPlacesAreThereOnce) {
  RunOptions run;
  std::set<std::string> names, places;
  for (const Option& option : optionsOf(run)) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_TRUE(option.place.empty() || places.insert(option.place).second) << option.place;
    EXPECT_EQ(option.giver != Giver::Library, !option.help.empty()) << option.name;
    EXPECT_FALSE(option.topic.empty()) << option.name;
  }
  EXPECT_GT(names.size(), 60U);
}

TEST(OptionTable, DefaultsAreFine) { EXPECT_EQ(said(firstError(RunOptions())), ""); }

/// Of every number with bounds: beyond either end it is refused by its name, and nothing else is.
TEST(OptionTable, WhatIsBeyondTheBoundsIsRefusedByName) {
  RunOptions first;
  int refused = 0;
  for (std::size_t i = 0; i < optionsOf(first).size(); ++i) {
    for (const bool top : {false, true}) {
      RunOptions run;
      const Option option = optionsOf(run)[i];
      const double end = top ? option.bounds.high : option.bounds.low;
      const bool open = top ? option.bounds.below : option.bounds.above;
      const double beyond = open ? end : end + (top ? 1.0 : -1.0);
      if (!std::isfinite(end) || !std::visit(Beyond{option, beyond}, option.value)) continue;
      EXPECT_EQ(said(firstError(run)).rfind(option.name + ", ", 0), 0U) << option.name << ' ' << beyond;
      ++refused;
    }
  }
  EXPECT_GT(refused, 35);
}

TEST(OptionTable, OptionsThatContradictEachOtherAreRefused) {
  RunOptions run;
  run.all = true, run.datum.pick = 2;
  EXPECT_EQ(said(firstError(run)), "pick, 2, expected no such option beside option all, which takes every tank");
  run = {};
  run.no_checksum = true, run.checksum = Checksum::Sha256;
  EXPECT_EQ(said(firstError(run)), "checksum, sha256, expected no such option beside option no_checksum");
  run = {};
  run.datum.shell.heights = {1.0, 2.0}, run.datum.shell.step = 0.25;
  EXPECT_EQ(said(firstError(run)), "height_step, 0.25, expected no such option beside option heights");
  run.datum.shell.step = ShellOptions().step;
  run.all = run.no_checksum = true, run.checksum = Checksum::None;
  EXPECT_EQ(said(firstError(run)), "");
}

TEST(OptionTable, RefusalsSayNameValueAndWhatIsExpected) {
  DatumOptions options;
  options.normals.k = 2;
  EXPECT_EQ(said(firstError(options)), "k, 2, expected >= 3");
  options = {};
  options.growing.angle = 2.0;
  EXPECT_EQ(said(firstError(options)), "angle_deg, 114.592, expected > 0 and < 90 deg");
  options = {};
  options.locate.min_arc = -1.0;
  EXPECT_EQ(said(firstError(options)), "locate.min_arc_deg, -57.2958, expected > 0 and <= 360 deg");
  options = {};
  options.analysis.facts.roof = "x = 1 (must be y)";
  EXPECT_EQ(said(firstError(options)), "roof, x = 1 (must be y), expected open or fixed");
}

TEST(OptionTable, AnAzimuthOffsetIsGivenOrFound) {
  MovementOptions options;
  options.estimate_offset = true;
  EXPECT_EQ(said(firstError(options)), "");
  options.azimuth_offset = 0.5;
  EXPECT_EQ(said(firstError(options)),
            "azimuth_offset_deg, 28.6479, expected 0 with option estimate_azimuth_offset, which finds it");
}

TEST(OptionTable, TheRecordHasEachAtItsPlaceInItsUnit) {
  RunOptions run;
  run.up = "-y";
  run.baseline = "earlier/datum.json";
  run.datum.growing.angle = 0.5235987755982988;
  run.datum.setups.origins["a"] = {1.0, 2.0, 3.0};
  run.datum.tank = Circle{{4.0, 5.0}, 6.0};
  run.datum.analysis.facts.yield = 235.0;
  run.movement.removal = Removal::Tilt;
  const auto json = optionsJson(run);
  EXPECT_EQ(json.at("up"), "-y");
  EXPECT_EQ(json.at("growing").at("angle_deg"), 30.0);
  EXPECT_EQ(json.at("setups").at("origins").dump(), R"({"a":[1.0,2.0,3.0]})");
  EXPECT_EQ(json.at("tank").dump(), "[4.0,5.0,6.0]");
  EXPECT_EQ(json.at("analysis").at("yield_mpa"), 235.0);
  EXPECT_TRUE(json.at("analysis").at("height").is_null());
  EXPECT_EQ(json.at("movement").at("remove"), "tilt");
  EXPECT_EQ(json.at("movement").at("baseline"), "earlier/datum.json");
  EXPECT_FALSE(json.contains("threads"));  // does not bear on the result
  EXPECT_EQ(movementValues(run.movement).at("remove"), "tilt");
}

TEST(OptionTable, TheListHasWhatPeopleCanGive) {
  const auto list = nlohmann::json::parse(optionsListed());
  const auto named = [&](const std::string& name) {
    for (const auto& option : list) {
      if (option.at("name") == name) return option;
    }
    return nlohmann::json();
  };
  EXPECT_EQ(named("k").at("default"), 20);
  EXPECT_EQ(named("k").at("expected"), ">= 3");
  EXPECT_EQ(named("search").at("words").dump(), R"(["flann","buckets"])");
  EXPECT_EQ(named("quiet").at("command_only"), true);
  EXPECT_TRUE(named("locate.min_arc_deg").is_null());
}

}  // namespace tank_datum::option_table_test
