#include "setups/setup_system.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tank_datum::setup_system_test {

/// A system that tells every parameter by itself, with the same weight.
SetupSystem systemOf(const Eigen::VectorXd& errors, double weight) {
  return {weight * Eigen::MatrixXd::Identity(errors.size(), errors.size()), weight * errors};
}

TEST(SolveSetups, AnErrorAsUncertainAsItsPriorIsHalved) {
  const Eigen::VectorXd errors = Eigen::VectorXd::Constant(5, 0.002);
  const SetupSolution solution =
      solveSetups(systemOf(errors, 1.0 / (0.003 * 0.003)), Eigen::VectorXd::Constant(5, 0.003));
  EXPECT_NEAR(solution.errors[0], 0.001, 1e-12);
  EXPECT_NEAR(solution.covariance(0, 0), 0.003 * 0.003 / 2.0, 1e-15);
  EXPECT_NEAR(solution.determined[0], 0.5, 1e-12);
  EXPECT_NEAR(solution.determined[1], 1.0, 1e-12);
}

TEST(SolveSetups, OfAFreedSetupEvenAMeasurementAHundredTimesWorseThanThePriorTellsHalf) {
  const Eigen::VectorXd priors = priorSigmas({0.002, 1e-4, 0.003}, {false, true});
  const Eigen::VectorXd errors = Eigen::VectorXd::Constant(10, 0.010);
  const SetupSolution solution = solveSetups(systemOf(errors, 1.0 / (0.2 * 0.2)), priors);
  EXPECT_NEAR(solution.errors[5], 0.005, 1e-6);
  EXPECT_LT(solution.errors[0], 0.00001);
}

TEST(EstimateSigmas, IsTheScatterOfTheErrorsLessTheWeakPrior) {
  // two heights, known exactly; the fixed point is sigma^2 (2 + ln(sigma / start) / 9) = the sum of their squares, and
  // the errors are chosen such that e times the start solves it
  const double start = 0.002, wanted = std::exp(1.0) * start;
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(10);
  errors[0] = wanted * std::sqrt(1.0 + 1.0 / 18.0), errors[5] = -errors[0];
  const KindSigmas found =
      estimateSigmas(systemOf(errors, 1e16), {start, 1.0, 1.0}, {false, true, true}, {false, false});
  EXPECT_NEAR(found[0], wanted, 0.005 * wanted);
  EXPECT_EQ(found[1], 1.0);
}

TEST(EstimateSigmas, AFreedSetupSaysNothing) {
  Eigen::VectorXd errors = Eigen::VectorXd::Constant(15, 0.002);
  errors[10] = 1.0;
  const KindSigmas found =
      estimateSigmas(systemOf(errors, 1e16), {0.002, 0.002, 0.002}, {false, true, true}, {false, false, true});
  EXPECT_NEAR(found[0], 0.002, 1e-5);
}

TEST(AssumedSigma, IsTheUsualOneAsUncertainAsThreeParametersLeaveIt) {
  EXPECT_NEAR(assumedSigma(0.003), 0.003 * std::sqrt(5.0 / 3.0), 1e-15);
}

TEST(AssumedSigma, IsThatOfFewSetupsWhereTheirErrorsAreLarger) {
  // two setups 30 mm apart: two errors of 15 mm, of which one is told
  const double seen = std::sqrt((3.0 * 4.0 + 450.0) / 4.0) * std::sqrt(1.5);
  EXPECT_NEAR(assumedSigma(0.002, 450e-6, 1.0), 1e-3 * seen, 1e-12);
  EXPECT_EQ(assumedSigma(0.002, 1e-6, 1.0), assumedSigma(0.002)) << "those that agree may do so by chance";
}

TEST(TemperedSigma, OfAQuarterOfTheUsualIsDrawnTowardsItAsIfByOneAndAHalfParameters) {
  const double usual = 0.002;
  // known by as many: half way on the logarithm's scale, and wider by Student's factor for three
  EXPECT_NEAR(temperedSigma(usual / 4.0, 1.5, usual), usual / 2.0 * std::sqrt(1.0 + 2.0 / 3.0), 1e-12);
}

TEST(TemperedSigma, FarBelowTheUsualSetupsAgreeAsOneAdjustmentMakesThem) {
  EXPECT_NEAR(temperedSigma(2e-6, 10.0, 0.002), 2e-6 * std::sqrt(1.2), 2e-9);
}

TEST(TemperedSigma, BesideTiltsThatAreAsUsualHeightsThatAgreeFarBetterAreChance) {
  const double usual = 0.002, known = 3.0, others = 1.0;  // worth one and a half
  const double drawn = std::exp((known * std::log(2e-6) + 1.5 * std::log(usual)) / (known + 1.5));
  EXPECT_NEAR(temperedSigma(2e-6, known, usual, others), drawn * std::sqrt(1.0 + 2.0 / (known + 1.5)), 1e-9);
  EXPECT_EQ(temperedSigma(usual / 2.0, known, usual, 1.9), temperedSigma(usual / 2.0, known, usual));
}

TEST(TemperedSigma, AboveTheUsualItIsOnlyWidened) {
  EXPECT_NEAR(temperedSigma(0.004, 8.0, 0.002), 0.004 * std::sqrt(1.25), 1e-12);
}

}  // namespace tank_datum::setup_system_test
