#include "setups/overlaps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum::overlaps_test {

/// The median of chi squared with one degree of freedom over its mean (Wilson and Hilferty), as the misfit has it.
const double kMedian = std::pow(1.0 - 2.0 / 9.0, 3);

/// An arc that two setups of its own see: the one `off` above the mean, the other below it.
ArcView arcOf(std::size_t number, double off, double information) {
  ArcView arc;
  arc.seen.setups = {2 * number, 2 * number + 1};
  arc.seen.offsets = Eigen::Vector2d(off, -off);
  arc.seen.information = information * (Eigen::Matrix2d() << 1.0, -1.0, -1.0, 1.0).finished();
  arc.motion = Eigen::MatrixXd::Zero(2, SetupMotion::kParameters);
  arc.motion.col(0).setOnes();
  return arc;
}

/// A solution without an error of a setup.
SetupSolution noErrors(std::size_t arcs) {
  SetupSolution solution;
  solution.errors = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * arcs) * SetupMotion::kParameters);
  return solution;
}

/// The weight on the height of the first setup of the last arc, once the arcs' errors are known.
double weightOfLast(const std::vector<ArcView>& arcs) {
  Overlaps overlaps(arcs, 2 * arcs.size());
  overlaps.learnFrom(noErrors(arcs.size()));
  const auto at = static_cast<Eigen::Index>(2 * (arcs.size() - 1)) * SetupMotion::kParameters;
  return overlaps.system().matrix(at, at);
}

/// The share of its weight that an arc keeps that is so many sigmas off, among arcs without a misfit.
double weightAt(double sigmas) {
  std::vector<ArcView> arcs;
  for (std::size_t a = 0; a < 9; ++a) arcs.push_back(arcOf(a, 0.0, 1e6));
  arcs.push_back(arcOf(9, 0.5e-3 * sigmas * std::sqrt(kMedian), 1e6));  // 4 offset^2 information are its square
  return weightOfLast(arcs) / 1e6;
}

TEST(Overlaps, AnArcCountsLessFromTwoAndAHalfSigmasOn) {
  EXPECT_DOUBLE_EQ(weightAt(2.4), 1.0);
  EXPECT_NEAR(weightAt(4.0), tukeyWeight(1.5) * 2.5 / 4.0, 1e-9);
}

/// The error in common that arcs are given whose setups are `off` above and below the mean [m].
double commonErrorOf(double off) {
  std::vector<ArcView> arcs;
  for (std::size_t a = 0; a < 9; ++a) arcs.push_back(arcOf(a, off, 1e10));
  return std::sqrt(0.5 / weightOfLast(arcs));  // of a difference 2 error^2 are the variance
}

TEST(Overlaps, ArcsAreGivenTheErrorThatTheyShowUpToATenthOfAMetre) {
  const double error = std::sqrt(2.0 / kMedian);  // for which 4 offset^2 / (2 error^2) is the median
  EXPECT_NEAR(commonErrorOf(0.001), 0.001 * error, 1e-6);
  EXPECT_NEAR(commonErrorOf(0.040), 0.040 * error, 1e-6);
  EXPECT_NEAR(commonErrorOf(0.070), 0.1, 1e-6);
}

/// What the setups disagree by when nine arcs show 1 mm and a tenth one so many times that.
double disagreementWith(double times) {
  std::vector<ArcView> arcs;
  for (std::size_t a = 0; a < 9; ++a) arcs.push_back(arcOf(a, 0.0005, 1e6));
  arcs.push_back(arcOf(9, 0.0005 * times, 1e6));
  SetupAdjustment result;
  result.errors = noErrors(arcs.size()).errors;
  result.bad.assign(2 * arcs.size(), false);
  measureDiscrepancy(Overlaps(arcs, 2 * arcs.size()), result);
  return result.all_before;
}

/// Five sigmas, of which the median square is 0.455 of one: 7.4 times the median.
TEST(MeasureDiscrepancy, BeyondFiveSigmasSomethingElseThanTheFoundationWasSeen) {
  EXPECT_NEAR(disagreementWith(7.0), 0.001 * std::sqrt((9.0 + 49.0) / 10.0), 1e-9);
  EXPECT_NEAR(disagreementWith(7.8), 0.001, 1e-9);
}

/// Two arcs so many degrees apart, each with setups of its own.
std::vector<ArcView> arcsApart(double degrees) {
  std::vector<ArcView> arcs = {arcOf(0, 1e-3, 1e6), arcOf(1, 1e-3, 1e6)};
  arcs[0].azimuth = 359.0 * kDegree;
  arcs[1].azimuth = std::fmod(359.0 + degrees, 360.0) * kDegree;
  return arcs;
}

TEST(Overlaps, WithoutAPlaceTheArcsWithinSixDegreesOfItAreLeftOut) {
  const auto weight = [](double degrees) {
    const std::vector<ArcView> arcs = arcsApart(degrees);
    const SetupSystem system = Overlaps(arcs, 4).systemWithout(arcs[0].azimuth);
    EXPECT_EQ(system.matrix(0, 0), 0.0);
    return system.matrix(2 * SetupMotion::kParameters, 2 * SetupMotion::kParameters);
  };
  EXPECT_EQ(weight(5.9), 0.0);
  EXPECT_NEAR(weight(6.1), 1e6, 1e-3);
}

TEST(Overlaps, PlacesAreThoseAtWhichASetupIsSeen) {
  const std::vector<ArcView> arcs = arcsApart(30.0);
  const Overlaps overlaps(arcs, 5);
  EXPECT_EQ(overlaps.placesOf(1), std::vector<double>{arcs[0].azimuth});
  EXPECT_EQ(overlaps.placesOf(3), std::vector<double>{arcs[1].azimuth});
  EXPECT_TRUE(overlaps.placesOf(4).empty());
}

}  // namespace tank_datum::overlaps_test
