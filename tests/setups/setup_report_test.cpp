#include "setups/setup_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"

namespace tank_datum::setup_report_test {

SetupAgreement badSetup(double dz, double tilt, double dx) {
  SetupAgreement agreement;
  Setup setup;
  setup.name = "north";
  setup.verdict = SetupVerdict::Bad;
  setup.correction.dz = dz, setup.correction.tilt_x = tilt, setup.correction.dx = dx;
  agreement.setups.push_back(setup);
  return agreement;
}

bool says(const SetupAgreement& agreement, const std::string& text, const std::vector<Station>& stations = {}) {
  return setupMessage(agreement, stations).find(text) != std::string::npos;
}

TEST(SetupMessage, ATiltIsTheFaultWhereItMovesMoreThanTheShiftThirtyMetresAway) {
  const double tilt = 1e-4;  // 3 mm over 30 m
  EXPECT_TRUE(says(badSetup(0.0025, tilt, 0.0), "tilted by 21 arc-seconds"));
  EXPECT_TRUE(says(badSetup(0.0040, tilt, 0.0), "4.0 mm too low"));
  EXPECT_TRUE(says(badSetup(0.0, tilt, 0.0025), "tilted by 21 arc-seconds"));
  EXPECT_TRUE(says(badSetup(0.0, tilt, 0.0040), "4.0 mm off in plan"));
  EXPECT_TRUE(says(badSetup(-0.0040, 0.0, 0.0020), "4.0 mm too high"));
}

TEST(SetupMessage, MergedScansThatDisagreeByMoreThanTwiceTheStationsOwnErrorAreTold) {
  std::vector<Station> stations(8);
  for (Station& s : stations) s.sigma_setup = 0.0003, s.sigma_z = 0.0005;  // 0.4 mm of its own
  SetupAgreement agreement;
  agreement.unlabelled_discrepancy = 0.00075;
  EXPECT_EQ(setupMessage(agreement, stations), "");
  agreement.unlabelled_discrepancy = 0.00085;
  EXPECT_TRUE(says(agreement, "disagree by about 0.8 mm", stations) ||
              says(agreement, "disagree by about 0.9 mm", stations));
}

TEST(SetupMessage, GroupsThatDifferByMoreThanTwiceTheStationsOwnErrorAreTold) {
  std::vector<Station> stations(8);
  for (Station& s : stations) s.sigma_setup = 0.0003, s.sigma_z = 0.0005;  // 0.4 mm of its own
  SetupAgreement agreement;
  agreement.setups.resize(4);
  agreement.setups[1].name = "north";
  agreement.higher = {1, 3};
  agreement.groups_apart = 0.00075;
  EXPECT_EQ(setupMessage(agreement, stations), "");
  agreement.groups_apart = 0.0051;
  EXPECT_TRUE(says(agreement, "setup north and 1 more are higher than the others by 5.1 mm", stations));
}

TEST(SetupMessage, ARegistrationFiveTimesWorseThanUsualIsTold) {
  SetupAgreement agreement;
  agreement.covariance = Eigen::MatrixXd::Identity(10, 10);  // adjusted
  agreement.spread = {0.0099, 0.0, 0.0099};
  EXPECT_EQ(setupMessage(agreement, {}), "");
  agreement.spread = {0.0131, 0.0, 0.0279};
  EXPECT_EQ(
      setupMessage(agreement, {}),
      "setups are registered to about 13.1 mm in height only; setups are registered to about 27.9 mm in plan only");
  agreement.given = {0.0131, 0.0, 0.0279};
  EXPECT_EQ(setupMessage(agreement, {}), "");
}

TEST(SetupMessage, SeparateFilesAreAskedForWhereTheyHelp) {
  SetupAgreement agreement;
  agreement.merged_sigma = 0.0028;
  EXPECT_TRUE(says(agreement, "2.8 mm: give them as separate files"));
  agreement.too_many = true;
  EXPECT_FALSE(says(agreement, "give them as separate files"));
}

TEST(SetupMessage, PartsOfSetupsAreTold) {
  SetupAgreement agreement;
  agreement.split = SplitSetups::ByLabel;
  EXPECT_TRUE(says(agreement, "files are parts of one cloud: points of equal labels are taken to be of one setup"));
  agreement.split = SplitSetups::ByDensity;
  EXPECT_TRUE(says(agreement, "show the same of the shell are taken to be parts of one setup"));
}

}  // namespace tank_datum::setup_report_test
