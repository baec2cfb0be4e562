#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/refined_scans.h"
#include "support/refused.h"

namespace tank_datum::refine_options_test {

using namespace refined_scans;

TEST(RefineOptions, WidestBandEndsTheSection) {
  RefineOptions options;
  options.widest_band = 0.15;
  EXPECT_NEAR(run(tank20(), padPoints(), options).refined.profile.edge, 0.15, 0.004);
  EXPECT_NEAR(padRun().refined.profile.edge, 0.3, 0.004);
}

TEST(RefineOptions, LargestWeldBeginsTheBand) {
  RefineOptions options;
  options.largest_weld = 0.025;
  EXPECT_GE(run(tank20(), padPoints(), options).refined.profile.band_from, 0.025);
  EXPECT_LT(padRun().refined.profile.band_from, 0.025);
}

/// Points behind a station, over all.
double supportOf(const Scanned& scanned) {
  double points = 0;
  for (const Station& s : scanned.stations) points += static_cast<double>(s.n_foundation.value_or(0)) / 360;
  return points;
}

TEST(RefineOptions, AStationGoodEnoughAloneLeansOnNoNeighbour) {
  RefineOptions options;
  options.wanted_sigma = 0.01;
  const Scanned alone = run(tank20(), padPoints(), options);
  EXPECT_GT(supportOf(padRun()), 1.2 * supportOf(alone));
  EXPECT_LT(padRun().rms, alone.rms);
}

TEST(RefineOptions, WideWindowsKnowTheirSigma) {
  RefineOptions options;
  options.wanted_sigma = 0.00005;
  const Scanned patient = run(tank20(), padPoints(), options);
  for (const Station& s : patient.stations) EXPECT_LT(s.sigma_z, 2.0 * patient.rms);
}

TEST(RefineOptions, ProfilePointsAreKeptAndMoveNothing) {
  EXPECT_TRUE(padRun().refined.sections.empty());
  RefineOptions options;
  options.profile_points = 30;
  const Scanned kept = run(tank20(), padPoints(), options);
  ASSERT_EQ(kept.refined.sections.size(), kept.stations.size());
  for (std::size_t i = 0; i < kept.stations.size(); ++i) {
    const StationProfile& section = kept.refined.sections[i];
    EXPECT_LE(section.points.size(), 30U);
    EXPECT_GE(section.points.size(), 15U);
    const auto elevation = [](const StationProfile& p) { return p.base + p.foundation; };
    EXPECT_NEAR(elevation(section) - elevation(kept.refined.sections[0]), kept.stations[i].z - kept.stations[0].z,
                1e-9);
    EXPECT_EQ(kept.stations[i].z, padRun().stations[i].z);
    EXPECT_EQ(kept.stations[i].sigma_z, padRun().stations[i].sigma_z);
  }
  options.profile_points = -1;
  EXPECT_EQ(said(firstError(options)), "refine.profile_points, -1, expected >= 0");
}

TEST(RefineOptions, AreRefusedByName) {
  EXPECT_EQ(said(firstError(RefineOptions())), "");
  const std::vector<std::pair<std::string, double RefineOptions::*>> fields = {
      {"largest_weld", &RefineOptions::largest_weld},
      {"widest_band", &RefineOptions::widest_band},
      {"widest_window", &RefineOptions::widest_window},
      {"wanted_sigma", &RefineOptions::wanted_sigma}};
  for (const auto& [name, field] : fields) {
    RefineOptions options;
    options.*field = -1.0;
    EXPECT_EQ(said(firstError(options)), "refine." + name + ", -1, expected > 0 m");
    options.*field = 0.0;
    EXPECT_NE(said(firstError(options)), "");
    options.*field = NAN;
    EXPECT_NE(said(firstError(options)), "");
  }
}

}  // namespace tank_datum::refine_options_test
