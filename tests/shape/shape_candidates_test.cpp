#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/units.h"
#include "shape/local_shapes.h"

namespace tank_datum::shape_candidates_test {

Eigen::VectorXd allRound(Eigen::Index count) {
  return Eigen::VectorXd::LinSpaced(count, 0.0, kTwoPi * static_cast<double>(count - 1) / static_cast<double>(count));
}

/// Half the widths that are looked for among so many stations, ascending [deg].
std::vector<double> widthsOf(Eigen::Index count) {
  std::set<double> widths;
  for (const CandidateShape& candidate : candidateShapes(allRound(count), allRound(count)))
    widths.insert(candidate.shape.half_width / kDegree);
  return {widths.begin(), widths.end()};
}

TEST(CandidateShapes, AreADegreeToThirtyOnEitherSideEachHalfAsWideAgain) {
  for (const Eigen::Index count : {360, 720}) {
    const std::vector<double> widths = widthsOf(count);
    EXPECT_NEAR(widths.front(), 1.0, 1e-9) << count;
    for (std::size_t i = 1; i < widths.size(); ++i) EXPECT_NEAR(widths[i] / widths[i - 1], 1.5, 1e-9);
    EXPECT_LE(widths.back(), 30.0);
    EXPECT_GT(1.5 * widths.back(), 30.0);
  }
  EXPECT_NEAR(widthsOf(72).front(), 5.0, 1e-9) << "a station's";
}

/// Stations of 1 mm sigma that show a shape of this height, in a model that can make the shape but for a part.
std::optional<LocalShape> found(double height, double part_left = 1.0) {
  const Eigen::VectorXd azimuths = allRound(360);
  const std::vector<CandidateShape> all = candidateShapes(azimuths, azimuths);
  const CandidateShape& candidate = all[all.size() / 2];
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(360, 1e6);
  Eigen::VectorXd residuals = Eigen::VectorXd::Zero(360);
  Eigen::MatrixXd design = Eigen::MatrixXd::Zero(360, 1);
  double information = 0.0;
  for (std::size_t k = 0; k < candidate.stations.size(); ++k) {
    residuals[candidate.stations[k]] = height * candidate.values[k];
    if (part_left < 1.0) design(candidate.stations[k], 0) = candidate.values[k];
    information += 1e6 * candidate.values[k] * candidate.values[k];
  }
  const double precision = part_left < 1.0 ? information / (1.0 - part_left) : 1.0;
  const Eigen::LLT<Eigen::MatrixXd> root(Eigen::MatrixXd::Constant(1, 1, precision));
  return likeliestShape({weights, residuals, design, root}, {candidate});
}

/// How high the shape must be that squares are less by so much.
double heightFor(double squares) {
  const std::vector<CandidateShape> all = candidateShapes(allRound(360), allRound(360));
  double information = 0.0;
  for (const double value : all[all.size() / 2].values) information += 1e6 * value * value;
  return std::sqrt(squares / information);
}

TEST(LikeliestShape, ExplainsTwiceTheStandardErrorOfItsHeight) {
  EXPECT_FALSE(found(heightFor(3.0)).has_value());
  EXPECT_TRUE(found(heightFor(6.0)).has_value());
}

TEST(LikeliestShape, MayBeThreeTimesAsHighAndItsDetailsATenth) {
  const auto shape = found(0.010);
  ASSERT_TRUE(shape.has_value());
  EXPECT_NEAR(shape->scale, 3.0 * 0.010, 1e-9);
  const std::vector<LocalShape> parts = withDetails(*shape, 1e-3);
  ASSERT_GT(parts.size(), 1U);
  for (std::size_t i = 1; i < parts.size(); ++i) EXPECT_NEAR(parts[i].scale, 0.1 * 0.010, 1e-9);
}

TEST(LikeliestShape, IsNoneThatTheModelMakesButForAMillionth) {
  EXPECT_FALSE(found(0.010, 0.8e-6).has_value());
  EXPECT_TRUE(found(0.010, 1.3e-6).has_value());
}

}  // namespace tank_datum::shape_candidates_test
