#include "movement/limit_rates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "movement/trend.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum::limit_rates_test {

constexpr double kSigma = 0.0001;  ///< of every figure [m]

Check figureOf(double value, double limit = 0.01) {
  Check check;
  check.code = "API 653", check.name = "out-of-plane settlement S_i", check.unit = "m", check.role = "governing";
  check.value = value, check.sigma = kSigma, check.limit = limit;
  return check;
}

/// Surveys on the first of January of years, each with one figure.
std::vector<Epoch> surveys(const std::vector<std::pair<int, double>>& figures) {
  std::vector<Epoch> all;
  for (const auto& [year, value] : figures) {
    Epoch epoch;
    epoch.date = std::to_string(year) + "-01-01";
    epoch.checks = {figureOf(value)};
    all.push_back(epoch);
  }
  return all;
}

LimitRate only(const std::vector<std::pair<int, double>>& figures) {
  const LimitRates found = limitRatesOf(surveys(figures));
  EXPECT_EQ(found.rates.size(), 1U) << found.none;
  return found.rates.empty() ? LimitRate() : found.rates.front();
}

TEST(LimitRatesOf, TwoSurveysGiveARateAndTheDateOfTheLimit) {
  const LimitRate rate = only({{2020, 0.002}, {2022, 0.004}});  // 1 mm a year, 6 mm left
  EXPECT_EQ(rate.approach, Approach::Reached);
  EXPECT_NEAR(rate.rate, 0.001, 1e-9);
  EXPECT_NEAR(rate.sigma, kSigma * std::sqrt(2.0) / 2.0, 1e-9);
  EXPECT_NEAR(rate.expected, 2028.0, 1e-6);
}

TEST(LimitRatesOf, TheEndsAreWhereTheBandMeetsTheLimit) {
  const LimitRate rate = only({{2020, 0.002}, {2022, 0.004}});
  for (const double end : {rate.earliest, rate.latest}) {
    const double from_middle = end - 2021.0, line = 0.003 + 0.001 * from_middle;
    const double sigma = kSigma * std::sqrt(0.5 + 0.5 * from_middle * from_middle);  // level 1/2, slope 1/2 a year^2
    EXPECT_NEAR(std::abs(0.01 - line), 1.959964 * sigma, 1e-8);
  }
  EXPECT_LT(rate.earliest, 2028.0);
  EXPECT_GT(rate.latest, 2028.0);
}

TEST(LimitRatesOf, WithoutARateThereIsNoDateButTheEarliest) {
  const LimitRate rate = only({{2020, 0.0040}, {2022, 0.0041}});
  EXPECT_EQ(rate.approach, Approach::NotBefore);
  EXPECT_TRUE(std::isnan(rate.expected));
  const double from_middle = rate.earliest - 2021.0;
  const double reach = 1.959964 * kSigma * std::sqrt(0.5 + 0.5 * from_middle * from_middle);
  EXPECT_NEAR(0.00405 + 0.00005 * from_middle + reach, 0.01, 1e-8);
  EXPECT_TRUE(std::isnan(rate.latest));
}

TEST(LimitRatesOf, AFallingFigureMovesAway) {
  EXPECT_EQ(only({{2020, 0.006}, {2022, 0.004}}).approach, Approach::Away);
}

TEST(LimitRatesOf, WhatIsBeyondItsLimitIsSaidToBe) {
  EXPECT_EQ(only({{2020, 0.009}, {2022, 0.011}}).approach, Approach::Beyond);
}

TEST(LimitRatesOf, AnIntervalDoesNotBeginBeforeTheLastSurvey) {
  const LimitRate rate = only({{2020, 0.0}, {2022, 0.00999}});
  EXPECT_EQ(rate.approach, Approach::Reached);
  EXPECT_EQ(rate.earliest, 2022.0);
}

TEST(LimitRatesOf, TwoCenturiesAreInSight) {
  const auto reachedAfter = [](double years) { return only({{1822, 0.0}, {2022, 0.01 - 0.00005 * years}}).approach; };
  EXPECT_EQ(reachedAfter(100.0), Approach::Reached);
  const auto slow = [](double years) {
    return only({{1822, 0.01 - 0.00003 * (200.0 + years)}, {2022, 0.01 - 0.00003 * years}});
  };
  EXPECT_EQ(slow(150.0).approach, Approach::Reached);
  EXPECT_EQ(slow(300.0).approach, Approach::NotInSight);
  EXPECT_TRUE(std::isnan(slow(300.0).earliest));
}

TEST(LimitRatesOf, FiguresThatScatterMoreThanTheirErrorsWidenTheInterval) {
  const LimitRate calm = only({{2019, 0.002}, {2020, 0.003}, {2021, 0.004}, {2022, 0.005}});
  const LimitRate wild = only({{2019, 0.0025}, {2020, 0.0025}, {2021, 0.0035}, {2022, 0.0055}});
  EXPECT_NEAR(calm.sigma, kSigma / std::sqrt(5.0), 1e-9);
  const double scatter = std::sqrt((4 * 0.0005 * 0.0005) / 2.0);  // residuals of half a millimetre, two degrees left
  EXPECT_NEAR(wild.sigma, scatter / std::sqrt(5.0), 1e-9);
  EXPECT_EQ(calm.approach, Approach::Reached);
  EXPECT_EQ(wild.approach, Approach::NotBefore);  // 4.3 of such sigmas, of Student's t, hold no rate
  EXPECT_LT(wild.earliest, calm.earliest);
}

TEST(LimitRatesOf, ScatterCountsFromThe95PercentPointOfChiSquare) {
  const auto sigmaAt = [](double misfit) {  // of three surveys: residuals r, -2r, r about a line
    const double r = kSigma * std::sqrt(misfit / 6.0);
    return only({{2020, 0.002 + r}, {2021, 0.003 - 2.0 * r}, {2022, 0.004 + r}}).sigma / (kSigma / std::sqrt(2.0));
  };
  EXPECT_NEAR(sigmaAt(3.5), 1.0, 1e-6);
  EXPECT_NEAR(sigmaAt(4.0), 2.0, 1e-6);  // the table has 3.84
}

TEST(LimitRatesOf, NineteenOfTwentyIntervalsHoldTheDate) {
  std::mt19937 random(1);
  std::normal_distribution<double> error(0.0, kSigma);
  int held = 0;
  constexpr int kTanks = 4000;
  for (int i = 0; i < kTanks; ++i) {
    const LimitRate rate =
        only({{2018, 0.002 + error(random)}, {2020, 0.0026 + error(random)}, {2023, 0.0035 + error(random)}});
    const double truth = 2018.0 + (0.01 - 0.002) / 0.0003;
    held += rate.earliest <= truth && !(rate.latest < truth) ? 1 : 0;
  }
  EXPECT_NEAR(held / static_cast<double>(kTanks), 0.95, 0.015);
}

TEST(LimitRatesOf, NoneOfItsDatesIsBeforeTheLastSurvey) {
  const double s = kSigma;
  const LimitRate rate = only({{2018, 0.002 - 0.1 * s}, {2019, 0.006 + 1.1 * s}, {2020, 0.01 - 0.1 * s}});
  EXPECT_EQ(rate.approach, Approach::Reached);
  EXPECT_EQ(rate.earliest, 2020.0);
  EXPECT_EQ(rate.expected, 2020.0) << "the line was at the limit a little before";
}

TEST(LimitRatesOf, SaysWhyThereAreNone) {
  std::vector<Epoch> all = surveys({{2020, 0.002}, {2022, 0.004}});
  all[1].date.clear();
  EXPECT_EQ(limitRatesOf(all).none, "limit_rate.no_dates");
  all[1].date = "in spring";
  EXPECT_EQ(limitRatesOf(all).none, "limit_rate.no_dates");
  all[1].date = "2019-12-31";
  EXPECT_EQ(limitRatesOf(all).none, "limit_rate.no_order");
  all = surveys({{2020, 0.002}, {2022, 0.004}});
  all[0].checks[0].clause = "another";
  EXPECT_EQ(limitRatesOf(all).none, "limit_rate.no_figures");
  all = surveys({{2020, 0.002}, {2022, 0.004}});
  all[1].checks[0].role = "for comparison";
  EXPECT_EQ(limitRatesOf(all).none, "limit_rate.no_figures");
}

TEST(LimitRatesOf, TheOneReachedFirstStandsFirst) {
  std::vector<Epoch> all = surveys({{2020, 0.002}, {2022, 0.004}});
  for (std::size_t i = 0; i < 2; ++i) {
    Check sooner = figureOf(i == 0 ? 0.002 : 0.004, 0.006), beyond = figureOf(0.02),
          away = figureOf(i == 0 ? 0.005 : 0.003);
    sooner.name = "sooner", beyond.name = "beyond", away.name = "away";
    for (const Check& check : {away, sooner, beyond}) all[i].checks.push_back(check);
  }
  std::vector<std::string> names;
  for (const LimitRate& rate : limitRatesOf(all).rates) names.push_back(rate.check.name);
  EXPECT_EQ(names, (std::vector<std::string>{"beyond", "sooner", "out-of-plane settlement S_i", "away"}));
}

TEST(MonthOf, IsThatOfTheCalendar) {
  EXPECT_EQ(monthOf(2031.0), "2031-01");
  EXPECT_EQ(monthOf(2031.29), "2031-04");
  EXPECT_EQ(monthOf(2031.9999), "2031-12");
  for (const char* first : {"2020-06-01", "2019-03-01", "2024-02-29", "2024-12-01"}) {
    EXPECT_EQ(monthOf(yearOf(first)), std::string(first).substr(0, 7));
  }
  EXPECT_EQ(monthOf(yearOf("2019-05-31")), "2019-05");
}

}  // namespace tank_datum::limit_rates_test
