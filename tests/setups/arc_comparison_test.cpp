#include "setups/arc_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum::arc_comparison_test {

constexpr ArcPrior kPrior{0.01, 0.001, 0.04};

/// Points of `setups` on a surface with a step between bins 2 and 3, a slope and a bend along it; setup s is s mm high.
std::vector<ArcPoint> madeArc(std::size_t setups, std::size_t per_setup, double noise, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-0.6, 0.6);
  std::vector<ArcPoint> points;
  for (std::size_t s = 0; s < setups; ++s) {
    for (std::size_t i = 0; i < per_setup; ++i) {
      const double t = place(random);
      const auto bin = static_cast<std::uint16_t>(i % 6);
      const double surface = (bin < 3 ? 0.010 : 0.0) + 0.004 * t + 0.0005 * t * t;
      points.push_back(
          {t, surface + 0.001 * static_cast<double>(s) + noise * normal(random), bin, static_cast<std::uint16_t>(s)});
    }
  }
  return points;
}

TEST(ArcComparison, OffsetsAreFoundWhateverTheSurface) {
  std::mt19937_64 random(1);
  const auto seen = compareArc(madeArc(3, 300, 0.0005, random), kPrior);
  ASSERT_TRUE(seen);
  ASSERT_EQ(seen->setups, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_NEAR(seen->offsets[1] - seen->offsets[0], 0.001, 0.00015);
  EXPECT_NEAR(seen->offsets[2] - seen->offsets[0], 0.002, 0.00015);
  EXPECT_NEAR(seen->offsets.sum(), 0.0, 1e-12);
}

TEST(ArcComparison, InformationIsThatOfTheMeansOfThePoints) {
  std::mt19937_64 random(2);
  constexpr double kNoise = 0.001;
  double squares = 0.0, said = 0.0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto seen = compareArc(madeArc(2, 240, kNoise, random), kPrior);
    ASSERT_TRUE(seen);
    const double error = seen->offsets[1] - seen->offsets[0] - 0.001;
    squares += error * error / kTrials;
    said += 1.0 / seen->information(0, 0) / kTrials;
    EXPECT_NEAR(seen->information(0, 0) + seen->information(0, 1), 0.0, 1e-6 * seen->information(0, 0));
  }
  EXPECT_NEAR(said, 2.0 * kNoise * kNoise / 240.0, 0.15 * said);
  EXPECT_NEAR(squares, said, 0.3 * said);
}

TEST(ArcComparison, AThirdOfThePointsOnSomethingElseChangesLittle) {
  std::mt19937_64 random(3);
  auto points = madeArc(2, 300, 0.0005, random);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    if (points[i].setup == 1) points[i].value += 0.020;
  }
  const auto seen = compareArc(points, kPrior);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->offsets[1] - seen->offsets[0], 0.001, 0.0003);
}

TEST(ArcComparison, ThirtyMillimetresApartAreCompared) {
  std::mt19937_64 random(4);
  auto points = madeArc(2, 300, 0.0005, random);
  for (ArcPoint& p : points) p.value += p.setup == 1 ? 0.029 : 0.0;
  const auto seen = compareArc(points, kPrior);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->offsets[1] - seen->offsets[0], 0.030, 0.0003);
}

TEST(ArcComparison, WhatOneSetupSeesAloneIsNotCompared) {
  std::mt19937_64 random(5);
  EXPECT_FALSE(compareArc(madeArc(1, 300, 0.0005, random), kPrior));
  EXPECT_FALSE(compareArc({}, kPrior));
  auto points = madeArc(2, 300, 0.0005, random);
  for (ArcPoint& p : points) p.bin = static_cast<std::uint16_t>(p.bin + 10 * p.setup);  // no bin in common
  EXPECT_FALSE(compareArc(points, kPrior));
  auto few = madeArc(2, 300, 0.0005, random);
  few.erase(few.begin() + 308, few.end());  // eight points of the second
  EXPECT_FALSE(compareArc(few, kPrior));
}

/// So many points of two setups in each of the bins, without noise, the second 1 mm higher.
std::vector<ArcPoint> evenArc(std::uint16_t bins, int first, int second) {
  std::vector<ArcPoint> points;
  for (std::uint16_t bin = 0; bin < bins; ++bin) {
    for (int i = 0; i < first; ++i) points.push_back({0.01 * i, 0.0, bin, 0});
    for (int i = 0; i < second; ++i) points.push_back({0.01 * i, 0.001, bin, 1});
  }
  return points;
}

TEST(ArcComparison, ASetupIsComparedFromTwelvePointsOnABinFromSix) {
  EXPECT_TRUE(compareArc(evenArc(4, 3, 3), kPrior));
  auto eleven = evenArc(4, 3, 3);
  eleven.pop_back();
  EXPECT_FALSE(compareArc(eleven, kPrior));
  auto five = evenArc(10, 3, 2);
  for (std::size_t i = 0; i < five.size(); ++i) five[i].value += i % 3 == 0 ? 0.002 : 0.0;
  EXPECT_FALSE(compareArc(five, kPrior));
}

TEST(ArcComparison, ThreePointsOfASetupInABinMakeAFirstMedianOfItTwoDoNot) {
  const auto seen = compareArc(evenArc(4, 4, 3), kPrior);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->offsets[1] - seen->offsets[0], 0.001, 1e-9);
  // without noise and without a first median all of the second setup's points look like something else
  EXPECT_FALSE(compareArc(evenArc(6, 4, 2), kPrior));
}

TEST(ArcComparison, ABinOfTwentyPointsTakesAThirdOfItsVarianceFromTheOthers) {
  constexpr double kRough = 0.010;
  std::vector<ArcPoint> points;
  for (std::uint16_t bin = 0; bin < 3; ++bin) {
    const double off = bin < 2 ? kRough / 1.4826 : 1e-6;  // two rough bins and a quiet one
    for (int i = 0; i < 20; ++i) {
      points.push_back({0.0, i % 2 == 0 ? off : -off, bin, static_cast<std::uint16_t>(i / 2 % 2)});
    }
  }
  const auto seen = compareArc(points, kPrior);
  ASSERT_TRUE(seen);
  // of each bin points / (4 noise^2), the rough ones' less their share that Tukey's weights take; the quiet one's
  // variance is a third of the others'
  const double rough = 20.0 / (4.0 * kRough * kRough), weight = std::pow(1.0 - std::pow(0.6745 / 4.685, 2), 2);
  constexpr double kFreedom = 56.0 / 60.0;  // three heights and an offset are determined
  EXPECT_NEAR(seen->information(0, 0), kFreedom * (2.0 * weight + 3.0) * rough, 0.03 * 5.0 * rough);
}

/// An arc of three parts whose middle lies 12 mm lower. Setup 0 sees the first two, setup 1, 1 mm higher, the others.
std::vector<ArcPoint> dippedArc(bool second_in_the_middle) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-0.6, 0.6);
  std::vector<ArcPoint> points;
  for (int i = 0; i < 1200; ++i) {
    const auto setup = static_cast<std::uint16_t>(i % 2);
    const auto part = static_cast<std::uint16_t>(setup + (setup == 1 && !second_in_the_middle ? 1 : i / 2 % 2));
    const auto bin = static_cast<std::uint16_t>(i / 4 % 6);
    const double surface = (part == 1 ? -0.012 : 0.0) + (bin < 3 ? 0.010 : 0.0);
    points.push_back({place(random), surface + 0.001 * setup + 0.0005 * normal(random), bin, setup, part});
  }
  return points;
}

TEST(ArcComparison, WhatASurfaceDoesBetweenPartsIsNoSetupsError) {
  constexpr ArcPrior kWide{0.01, 0.001, 0.04, 3, 0.05};
  const auto seen = compareArc(dippedArc(true), kWide);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->offsets[1] - seen->offsets[0], 0.001, 0.0002);
  // of two parts that no setup shares with another the difference is known as their heights are
  const auto apart = compareArc(dippedArc(false), kWide);
  ASSERT_TRUE(apart);
  EXPECT_NEAR(1.0 / std::sqrt(apart->information(0, 0)), 0.05 * std::sqrt(1.5), 0.001);
}

/// Points of two setups in one bin, so many of each in each of six parts, the second setup 1 mm higher.
std::vector<ArcPoint> sparseArc(int of_part, double noise, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-0.6, 0.6);
  std::vector<ArcPoint> points;
  for (std::uint16_t part = 0; part < 6; ++part) {
    for (int i = 0; i < 2 * of_part; ++i) {
      const auto setup = static_cast<std::uint16_t>(i % 2);
      points.push_back({place(random), 0.005 * part + 0.001 * setup + noise * normal(random), 0, setup, part});
    }
  }
  return points;
}

constexpr ArcPrior kSparse{0.01, 0.001, 0.04, 6, 0.05};

TEST(ArcComparison, WhatFewPointsDetermineIsLackingInTheirScatter) {
  std::mt19937_64 random(9);
  constexpr int kTrials = 400;
  double squares = 0.0, said = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto seen = compareArc(sparseArc(6, 0.001, random), kSparse);
    ASSERT_TRUE(seen);
    const double error = seen->offsets[1] - seen->offsets[0] - 0.001;
    squares += error * error / kTrials;
    said += 1.0 / seen->information(0, 0) / kTrials;
  }
  EXPECT_NEAR(squares / said, 1.0, 0.2);
}

TEST(ArcComparison, SettledIsNothingWhereHalfOfThePointsAreFittedExactly) {
  std::mt19937_64 random(10);
  EXPECT_FALSE(compareArc(sparseArc(2, 0.001, random), kSparse));
  EXPECT_TRUE(compareArc(sparseArc(6, 0.001, random), kSparse));
}

}  // namespace tank_datum::arc_comparison_test
