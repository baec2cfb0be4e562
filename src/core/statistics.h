#pragma once

#include <vector>

namespace tank_datum {

/// The values that are finite, in their order.
std::vector<double> finiteOf(const std::vector<double>& values);

/// The middle value (mean of the two middle ones for an even count); NaN for no values.
double median(std::vector<double> values);

/// Standard error of the median of many normal values over that of their mean: the root of pi / 2.
constexpr double kMedianOverMean = 1.2533;

struct WeightedValue {
  double value, weight;  ///< weights above 0
};

/// The value at which half of the weight is reached, the mean of two where one ends on it; NaN for no values.
double weightedMedian(std::vector<WeightedValue> values);

/// The value below which the share `q` in [0, 1] of the values lies (nearest rank); NaN for no values.
double quantile(std::vector<double> values, double q);

/// Robust standard deviation: 1.4826 times the median absolute deviation from `center`; NaN for no values.
double robustSigma(const std::vector<double>& values, double center);

/// Root of the biweight midvariance about the median with the constant 9 (Lax, J. Amer. Stat. Assoc. 80, 1985): a
/// robust standard deviation that is 87 % efficient for normal errors, where robustSigma is 37 %, but more moved by
/// values that stand out by less than six sigmas. 0 where more than half of the values are equal; NaN for no values.
double biweightSigma(const std::vector<double>& values);

/// The densest place of sorted values: the half-sample mode (Bickel and Fruehwirth 2006).
/// @param sorted  not empty
double halfSampleMode(const std::vector<double>& sorted);

/// Tukey's biweight with the constant 4.685 (95 % efficient for normal errors) of the residual in sigmas.
double tukeyWeight(double residual_in_sigmas);

/// Two-sided 95 % point of Student's t: of the normal distribution for 0 degrees of freedom, which stands for
/// infinitely many. Source: Abramowitz and Stegun 26.7.5; exact for 1 and 2.
double student95(double freedom);

/// Quantile of Student's t, for 0 degrees of freedom that of the normal distribution.
/// @param freedom  at least 3 for 2 % in the far tails; of 2 the point of 98.75 % comes out 4 % too low, of 1 a third
/// @param deviate  the same quantile of the normal distribution
/// Source: Abramowitz and Stegun 26.7.5.
double studentQuantile(double freedom, double deviate);

/// Quantile of chi-square.
/// @param deviate  the same quantile of the normal distribution: 0 for the median, 1.6449 for the 95 % point
/// Source: Wilson and Hilferty; Abramowitz and Stegun 26.4.17.
double chiSquareQuantile(double freedom, double deviate);

/// Quantile of the variance ratio F, the first variance with the freedom of the first.
/// @param second   at least 8
/// @param deviate  the same quantile of the normal distribution
/// Source: Paulson (1942), by Wilson and Hilferty; Abramowitz and Stegun 26.6.15.
double fQuantile(double first, double second, double deviate);

}  // namespace tank_datum
