#include "core/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tank_datum::statistics_test {

TEST(FiniteOf, LeavesOutWhatIsNotKnownOrHasNoEnd) {
  EXPECT_EQ(finiteOf({3.0, NAN, -1.0, HUGE_VAL, 2.0}), (std::vector<double>{3.0, -1.0, 2.0}));
  EXPECT_TRUE(finiteOf({NAN}).empty());
}

TEST(Median, IsTheMiddleOfAnOddCount) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, -4, 2}), 2);
}

TEST(Median, IsTheMeanOfTheTwoMiddleOnesOfAnEvenCount) {
  EXPECT_EQ(median({1, 3}), 2);
  EXPECT_EQ(median({100, 2, 3, -50}), 2.5);
}

TEST(Median, OfNothingIsUnknown) { EXPECT_TRUE(std::isnan(median({}))); }

TEST(Median, TakesEqualValues) { EXPECT_EQ(median({5, 5, 5, 5}), 5); }

TEST(Median, ScattersAsSaidMoreThanTheMeanOfNormalErrors) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  double medians = 0.0, means = 0.0;
  for (int draw = 0; draw < 4000; ++draw) {
    std::vector<double> values(101);
    for (double& value : values) value = normal(random);
    double sum = 0.0;
    for (const double value : values) sum += value / 101.0;
    medians += std::pow(median(values), 2);
    means += sum * sum;
  }
  EXPECT_NEAR(std::sqrt(medians / means), kMedianOverMean, 0.03);  // its own error: 0.014
}

TEST(Quantile, IsTheNearestRankOfFourValues) {
  const std::vector<double> values = {40, 10, 30, 20};
  EXPECT_EQ(quantile(values, 0.0), 10);
  EXPECT_EQ(quantile(values, 0.24), 10);
  EXPECT_EQ(quantile(values, 0.25), 20);
  EXPECT_EQ(quantile(values, 0.5), 30);
  EXPECT_EQ(quantile(values, 0.99), 40);
  EXPECT_EQ(quantile(values, 1.0), 40);
}

TEST(Quantile, OfNothingIsUnknown) { EXPECT_TRUE(std::isnan(quantile({}, 0.5))); }

TEST(WeightedMedian, OfEqualWeightsIsTheMedian) {
  EXPECT_EQ(weightedMedian({{9, 2}, {-4, 2}, {2, 2}}), 2);
  EXPECT_EQ(weightedMedian({{100, 1}, {2, 1}, {3, 1}, {-50, 1}}), 2.5);
  EXPECT_EQ(weightedMedian({{7, 3}}), 7);
}

TEST(WeightedMedian, LeavesHalfOfTheWeightOnEitherSide) {
  EXPECT_EQ(weightedMedian({{1, 1}, {2, 1}, {3, 1}, {10, 4}}), 10);
  EXPECT_EQ(weightedMedian({{10, 3}, {1, 1}, {3, 1}, {2, 1}}), 6.5);
  EXPECT_EQ(weightedMedian({{1, 5}, {10, 4}}), 1);
}

TEST(WeightedMedian, OfNothingIsUnknown) { EXPECT_TRUE(std::isnan(weightedMedian({}))); }

TEST(RobustSigma, IsTheScaledMedianOfTheDeviationsFromTheGivenCentre) {
  EXPECT_DOUBLE_EQ(robustSigma({-1, 0, 2}, 0.0), 1.4826);
  EXPECT_DOUBLE_EQ(robustSigma({9, 10, 12}, 10.0), 1.4826);
  EXPECT_DOUBLE_EQ(robustSigma({9, 10, 12}, 0.0), 14.826);
  EXPECT_EQ(robustSigma({3, 3, 3}, 3.0), 0.0);
  EXPECT_TRUE(std::isnan(robustSigma({}, 0.0)));
}

TEST(RobustSigma, IsTheStandardDeviationOfNormalErrorsAndIgnoresAFewGrossOnes) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 2.0);
  std::vector<double> values(20'000);
  for (double& v : values) v = normal(random);
  EXPECT_NEAR(robustSigma(values, 0.0), 2.0, 0.05);
  for (std::size_t i = 0; i < 200; ++i) values[i] = 1e6;
  EXPECT_NEAR(robustSigma(values, 0.0), 2.0, 0.08);
}

TEST(BiweightSigma, OfFourValuesIsWhatItsFormulaGives) {
  // median 0, median absolute deviation 1, u = 1/9: sqrt(4 * 4 * (80/81)^4) / (4 * 80/81 * 76/81)
  EXPECT_NEAR(biweightSigma({-1, 1, -1, 1}), 80.0 / 76.0, 1e-15);
  EXPECT_NEAR(biweightSigma({9, 11, 9, 11, 1000}), biweightSigma({9, 11, 9, 11, 2000}), 1e-12) << "beyond nine";
  EXPECT_EQ(biweightSigma({3, 3, 3, 4}), 0.0);
  EXPECT_TRUE(std::isnan(biweightSigma({})));
}

TEST(BiweightSigma, OfTwelveNormalErrorsScattersByLessThanTheMedianDeviation) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 2.0);
  double sum = 0.0, squares = 0.0, squares_of_median = 0.0, sum_of_median = 0.0;
  constexpr int kRuns = 4000;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<double> values(12);
    for (double& v : values) v = normal(random);
    const double sigma = biweightSigma(values), other = robustSigma(values, median(values));
    sum += sigma, squares += sigma * sigma, sum_of_median += other, squares_of_median += other * other;
  }
  const auto relative = [](double s, double s2) { return std::sqrt(s2 * kRuns / (s * s) - 1.0); };
  EXPECT_NEAR(sum / kRuns, 0.94 * 2.0, 0.03);
  EXPECT_NEAR(relative(sum, squares), 0.23, 0.01);  // sqrt(1 / (2 * 0.87 * 11))
  EXPECT_NEAR(relative(sum_of_median, squares_of_median), 0.33, 0.01);
}

TEST(TukeyWeight, IsOneInTheMiddleAndNothingFrom4Point685SigmasOn) {
  EXPECT_EQ(tukeyWeight(0.0), 1.0);
  EXPECT_DOUBLE_EQ(tukeyWeight(4.685 / 2), 0.5625);  // (1 - 1/4)^2
  EXPECT_GT(tukeyWeight(4.68), 0.0);
  EXPECT_EQ(tukeyWeight(4.685), 0.0);
  EXPECT_EQ(tukeyWeight(100.0), 0.0);
}

TEST(TukeyWeight, DoesNotAskForTheSign) { EXPECT_EQ(tukeyWeight(-1.5), tukeyWeight(1.5)); }

TEST(Student95, OfTables) {
  for (const auto& [freedom, expected] : {std::pair{1.0, 12.706},
                                          {2.0, 4.303},
                                          {3.0, 3.182},
                                          {5.0, 2.571},
                                          {11.0, 2.201},
                                          {30.0, 2.042},
                                          {1e6, 1.960},
                                          {0.0, 1.960}}) {
    EXPECT_NEAR(student95(freedom) / expected, 1.0, 0.0012) << freedom;  // the expansion's error at 3: 0.11 %
  }
}

TEST(StudentQuantile, OfTables) {
  constexpr double kNormal = 2.4977;  // the two-sided point of 98.75 %
  EXPECT_NEAR(studentQuantile(5.0, kNormal), 3.810, 0.01);
  EXPECT_NEAR(studentQuantile(30.0, kNormal), 2.657, 0.002);
  EXPECT_EQ(studentQuantile(0.0, kNormal), kNormal);
}

TEST(ChiSquareQuantile, OfTables) {
  // the approximation's own error: 2.5 % at 1 degree of freedom, 0.4 % at 4
  EXPECT_NEAR(chiSquareQuantile(1.0, 1.6448536) / 3.841, 1.0, 0.026);
  EXPECT_NEAR(chiSquareQuantile(4.0, 1.6448536) / 9.488, 1.0, 0.004);
  EXPECT_NEAR(chiSquareQuantile(4.0, 0.0) / 3.357, 1.0, 0.004);
}

TEST(FQuantile, IsThatOfTables) {
  constexpr double k95 = 1.6448536, k99 = 2.3263479;
  EXPECT_NEAR(fQuantile(3.0, 16.0, k95) / 3.239, 1.0, 0.005);
  EXPECT_NEAR(fQuantile(3.0, 10.0, k99) / 6.552, 1.0, 0.03);
  EXPECT_NEAR(fQuantile(2.0, 12.0, k99) / 6.927, 1.0, 0.03);
  EXPECT_NEAR(fQuantile(16.0, 3.0, -k95) * 3.239, 1.0, 0.005);
  EXPECT_NEAR(3.0 * fQuantile(3.0, 1e9, k99) / chiSquareQuantile(3.0, k99), 1.0, 1e-6);
}

}  // namespace tank_datum::statistics_test
