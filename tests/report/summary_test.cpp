#include <gtest/gtest.h>

#include "support/made_datums.h"
#include "tank_datum/report/report.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::summary_test {

using made_datums::octagon;

/// "out of plane at most -0.0 mm" and the high side of no tilt are no facts.
TEST(Summary, ASizeOfZeroHasNeitherSignNorSide) {
  Datum datum = octagon();
  datum.tilt.sigma_slope = 1e-5;
  EXPECT_NE(summary(datum).find(" +- 4.1 (2 sigma), high side at "), std::string::npos) << summary(datum);
  datum.analysis.out_of_plane.max_u = 1e-6, datum.analysis.out_of_plane.max_u_azimuth = 1.0;
  for (Station& s : datum.stations) s.u = -1e-6;
  EXPECT_NE(summary(datum).find("; out of plane at most 0.0 mm at 57 deg\n"), std::string::npos) << summary(datum);
  datum.tilt.gradient = {1.9e-5, 0.0};
  EXPECT_NE(summary(datum).find("tilt           3.9 arc-seconds +- 4.1 (2 sigma), not significant;"),
            std::string::npos);
  datum.tilt.sigma_slope = kUnknown;
  EXPECT_NE(summary(datum).find("tilt           3.9 arc-seconds, high side at "), std::string::npos);
  datum.tilt.gradient = {1e-9, 0.0};
  EXPECT_NE(summary(datum).find("tilt           0.0 arc-seconds, not significant;"), std::string::npos);
}

TEST(Summary, ListsASecondOpinionAfterWhatGoverns) {
  const auto check = [](const char* name, const char* role, double value) {
    Check made;
    made.code = "A", made.name = name, made.role = role, made.unit = "m";
    made.value = value, made.limit = 0.010, made.verdict = Verdict::Fail;
    return made;
  };
  Datum datum = octagon();
  datum.analysis.checks = {check("second", "second opinion", 0.03), check("milder", "judged", 0.015),
                           check("first", "governing", 0.02)};
  const std::string text = summary(datum);
  const auto at = [&](const char* name) { return text.find(std::string("fail           A ") + name); };
  EXPECT_LT(at("first"), at("milder")) << text;
  EXPECT_LT(at("milder"), at("second")) << text;
  EXPECT_NE(text.find("30.0 mm, limit 10.0 mm (a second opinion)\n"), std::string::npos) << text;
}

TEST(Summary, SaysWhatTheShellStandsUpon) {
  Datum datum = octagon();
  EXPECT_EQ(summary(datum).find("ringwall  "), std::string::npos);
  datum.tank.ringwall_height = 0.9, datum.tank.ringwall_width = 0.06;
  EXPECT_NE(
      summary(datum).find("ringwall       the shell begins 0.9 m above the ground, upon what stands out by 0.06 m\n"),
      std::string::npos)
      << summary(datum);
}

TEST(Summary, NamesTheArcsInWhichAnotherWallStands) {
  Datum datum = octagon();
  EXPECT_EQ(summary(datum).find("another wall"), std::string::npos);
  for (const std::size_t i : {2U, 3U, 4U}) datum.stations[i].reason = Unmeasured::OffCircle;
  EXPECT_NE(summary(datum).find("another wall   at 90 to 180 deg what stands there is not the shell"),
            std::string::npos)
      << summary(datum);
}

TEST(Summary, NamesArcsOfThreeDegreesAndMore) {
  Datum datum = octagon();
  const auto named = [&](std::size_t stations, std::size_t count) {
    datum.stations.assign(stations, octagon().stations.front());
    for (std::size_t i = 0; i < count; ++i) datum.stations[i].reason = Unmeasured::OffCircle;
    return summary(datum).find("another wall") != std::string::npos;
  };
  EXPECT_FALSE(named(360, 2));
  EXPECT_TRUE(named(360, 3));
  EXPECT_FALSE(named(3600, 29));
  EXPECT_TRUE(named(3600, 30));
  EXPECT_TRUE(named(36, 1)) << "ten degrees";
}

TEST(Summary, NamesTheArcsInWhichTooLittleIsSeen) {
  Datum datum = octagon();
  datum.refined.profile.band_to = 0.1, datum.refined.profile.surface = Surface::Ringwall;
  for (const std::size_t i : {2U, 3U, 4U}) datum.stations[i].reason = Unmeasured::Hidden;
  datum.stations[6].reason = Unmeasured::NoShell;
  const std::string text = summary(datum);
  EXPECT_NE(text.find("hidden         at 90 to 180 deg too few points of the ringwall are seen beside the shell"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("no shell       at 270 to 270 deg the shell is not seen"), std::string::npos) << text;
}

TEST(Summary, NamesTheArcsInWhichSomethingElseMeetsTheShell) {
  Datum datum = octagon();
  datum.refined.profile.band_to = 0.1, datum.refined.profile.surface = Surface::Ringwall;
  for (const std::size_t i : {2U, 3U, 4U}) datum.stations[i].reason = Unmeasured::OtherSurface;
  EXPECT_NE(summary(datum).find("something else than the ringwall meets the shell, soil or a kerb"), std::string::npos)
      << summary(datum);
  datum.tank.side = Side::Inside;
  EXPECT_NE(summary(datum).find("something else than the floor meets the shell, liquid or a coil"), std::string::npos)
      << summary(datum);
}

/// Where the shell is seen below its neighbours' level the datum is not lifted by a heave.
TEST(Summary, NoHeaveIsNamedWhereTheShellIsSeenBelow) {
  Datum datum = octagon();
  datum.stations[6].z_refused = datum.stations[2].z_refused = 0.5;
  EXPECT_NE(summary(datum).find("in doubt       at 90 to 90, 270 to 270 deg"), std::string::npos) << summary(datum);
  datum.stations[6].reason = Unmeasured::ShellBelow;
  EXPECT_NE(summary(datum).find("in doubt       at 90 to 90 deg"), std::string::npos) << summary(datum);
}

}  // namespace tank_datum::summary_test
