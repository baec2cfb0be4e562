#include "setups/one_tripod.h"

#include <gtest/gtest.h>

namespace tank_datum::one_tripod_test {

constexpr int kParameters = SetupMotion::kParameters;

/// Parts whose differences are known to 0.1 mm and 4 arc-seconds, as wide overlaps tell them, of setups that err by
/// 2 mm and 10 arc-seconds: what all share is known no better than that.
SetupAdjustment partsThatErr(const std::vector<double>& heights) {
  SetupAdjustment adjusted;
  adjusted.spread = {0.002, 5e-5, 0.002};
  adjusted.height_estimated = adjusted.tilt_estimated = adjusted.plan_estimated = true;
  const auto count = static_cast<Eigen::Index>(heights.size());
  adjusted.bad.assign(heights.size(), false);
  adjusted.errors = Eigen::VectorXd::Zero(count * kParameters);
  adjusted.covariance = Eigen::MatrixXd::Zero(count * kParameters, count * kParameters);
  for (Eigen::Index i = 0; i < count; ++i) {
    adjusted.errors[i * kParameters] = heights[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < count; ++j) {
      for (int k = 0; k < kParameters; ++k) {
        const bool tilt = k == 1 || k == 2;
        const double shared = tilt ? 5e-5 : 0.002, own = tilt ? 1.4e-5 : 7e-5;
        adjusted.covariance(i * kParameters + k, j * kParameters + k) = shared * shared + (i == j ? own * own : 0.0);
      }
    }
  }
  return adjusted;
}

using Setups = std::vector<std::uint16_t>;

TEST(SetupsOfParts, PartsThatErrAlikeAreOfOneTripod) {
  EXPECT_EQ(setupsOfParts(partsThatErr({0.001, 0.0011, -0.002, 0.001, -0.0021})), (Setups{0, 0, 1, 0, 1}));
  EXPECT_EQ(setupsOfParts(partsThatErr({0.001, 0.0016, -0.002})), (Setups{0, 1, 2})) << "six standard errors apart";
}

TEST(SetupsOfParts, NothingIsToldOfSetupsThatAgree) {
  SetupAdjustment agree = partsThatErr({0.0, 0.0, 0.0});
  agree.spread = {1e-4, 1e-5, 1e-4};
  EXPECT_EQ(setupsOfParts(agree), (Setups{0, 1, 2}));
}

TEST(SetupsOfParts, EachStandsAloneWhereOverlapsDoNotTellTheirErrors) {
  SetupAdjustment assumed = partsThatErr({0.001, 0.001, -0.002});
  assumed.plan_estimated = false;
  EXPECT_EQ(setupsOfParts(assumed), (Setups{0, 1, 2}));
}

TEST(SetupsOfParts, TheMoreChancesTheSurer) {
  EXPECT_EQ(setupsOfParts(partsThatErr({0.0, 0.00035})), (Setups{0, 0}));
  std::vector<double> many(40, 0.0);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = 0.00035 * static_cast<double>(i);
  const Setups setups = setupsOfParts(partsThatErr(many));
  EXPECT_EQ(setups.back(), 39) << "780 pairs";
}

}  // namespace tank_datum::one_tripod_test
