#include "movement/trend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.h"
#include "tank_datum/core/error.h"

namespace tank_datum::trend_test {

/// A comparison of `count` stations that moved by `dz`, 0.3 mm of error in each survey, its frame turned by `turned`.
Movement moved(double dz, std::size_t count = 360, double turned = 0.0) {
  Movement movement;
  for (std::size_t i = 0; i < count; ++i) {
    StationMovement s;
    s.azimuth = 360.0 * kDegree * static_cast<double>(i) / static_cast<double>(count);
    s.direction = s.azimuth + turned;
    s.dz = dz, s.sigma = 0.0003 * std::sqrt(2.0), s.sigma_baseline = 0.0003;
    movement.stations.push_back(s);
  }
  return movement;
}

std::string refusal(const std::vector<Movement>& movements, const std::vector<double>& times) {
  try {
    historiesOf(movements, times);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(HistoriesOf, TheLargestRateIsComparedWithTheLargestOfAsMany) {
  const auto at = [](double sigmas) {
    Movement movement = moved(0.0);
    movement.stations[90].dz = sigmas * 0.0003 * std::sqrt(2.0);
    return historiesOf({movement}, {0, 1})[90].significant;
  };
  EXPECT_FALSE(at(3.0));  // one of 360 is that far off in most tanks
  EXPECT_FALSE(at(3.7));
  EXPECT_TRUE(at(3.9));  // 1 - 0.95^(1/360) is the chance beyond 3.80
}

TEST(HistoriesOf, FitsALineThroughEverySurvey) {
  const auto histories = historiesOf({moved(-0.001), moved(-0.002), moved(-0.003)}, {0, 1, 2, 3});
  ASSERT_EQ(histories.size(), 360U);
  EXPECT_NEAR(histories[7].rate, -0.001, 1e-12);
  EXPECT_NEAR(histories[7].sigma_rate, 0.0003 / std::sqrt(5.0), 1e-12);  // sum of (t - 1.5)^2
  EXPECT_NEAR(histories[7].lod95(), 1.96 * 0.0003 / std::sqrt(5.0), 1e-8);
  EXPECT_EQ(histories[7].surveys.size(), 3U);
}

TEST(HistoriesOf, ASurveyThatIsOffTheLineWidensItsError) {
  const auto sigmaWith = [](double off) {  // the third of five, of which it moves the mean by a fifth
    return historiesOf({moved(-0.001), moved(-0.002 + off), moved(-0.003), moved(-0.004)}, {0, 1, 2, 3, 4})[7]
        .sigma_rate;
  };
  const double own = 0.0003 / std::sqrt(10.0);
  const auto misfit = [](double off) { return 0.8 * off * off / (0.0003 * 0.0003); };
  const double inside = 0.0003 * std::sqrt(7.6 / 0.8), beyond = 0.0003 * std::sqrt(8.1 / 0.8);
  EXPECT_NEAR(sigmaWith(inside), own, 1e-9) << "7.81 is the 95 % point of chi squared with three";
  EXPECT_NEAR(sigmaWith(beyond), own * std::sqrt(8.1 / 3.0) * 3.182 / 1.96, 1e-6);
  EXPECT_NEAR(sigmaWith(0.03), own * std::sqrt(misfit(0.03) / 3.0) * 3.182 / 1.96, 1e-5);
}

TEST(HistoriesOf, TakesTheTimesAsTheyAre) {
  const auto slow = historiesOf({moved(-0.004)}, {2010, 2020});
  EXPECT_NEAR(slow[0].rate, -0.0004, 1e-12);
  EXPECT_NEAR(slow[0].sigma_rate, 0.0003 * std::sqrt(2.0) / 10.0, 1e-12);
  const auto uneven = historiesOf({moved(-0.001), moved(-0.004)}, {0, 1, 4});
  EXPECT_NEAR(uneven[0].rate, -0.001, 1e-12);
}

TEST(HistoriesOf, APlaceNotSeenInOneSurveyHasTheRateOfTheOthers) {
  std::vector<Movement> movements = {moved(-0.005), moved(-0.002)};
  movements[0].stations[50].dz = NAN;
  movements[1].stations[60].dz = NAN;
  for (Movement& m : movements) m.stations[70].dz = NAN;
  const auto histories = historiesOf(movements, {0, 1, 2});
  EXPECT_NEAR(histories[50].rate, -0.001, 1e-12);
  EXPECT_TRUE(std::isfinite(histories[50].surveys[1].dz));
  EXPECT_NEAR(histories[60].rate, -0.005, 1e-12);
  EXPECT_TRUE(std::isnan(histories[70].rate));
  EXPECT_TRUE(std::isnan(histories[70].sigma_rate));
}

TEST(HistoriesOf, APlaceBetweenTwoStationsNeedsBoth) {
  Movement gap = moved(-0.001);
  gap.stations[50].dz = NAN;
  const auto histories = historiesOf({gap, moved(-0.002, 360, 0.5 * kDegree)}, {0, 1, 2});
  EXPECT_NEAR(histories[48].surveys[0].dz, -0.001, 1e-12);  // 48.5 degrees
  EXPECT_TRUE(std::isnan(histories[49].surveys[0].dz));
  EXPECT_TRUE(std::isnan(histories[50].surveys[0].dz));
  EXPECT_NEAR(histories[51].surveys[0].dz, -0.001, 1e-12);
}

TEST(HistoriesOf, MatchesSurveysOfOtherCountsAndFramesByDirection) {
  const auto histories = historiesOf({moved(-0.001, 90), moved(-0.002, 360, 30 * kDegree)}, {0, 1, 2});
  EXPECT_NEAR(histories[2].direction, 32 * kDegree, 1e-9);
  EXPECT_NEAR(histories[2].surveys[0].dz, -0.001, 1e-12);  // 32 degrees, a station of the 90
  EXPECT_TRUE(std::isnan(histories[3].surveys[0].dz));     // 33 degrees, its neighbours are 4 apart
}

TEST(HistoriesOf, RefusesTimesThatAreNone) {
  EXPECT_NE(refusal({moved(0)}, {0}).find("one for each of the 2 surveys"), std::string::npos);
  EXPECT_NE(refusal({moved(0)}, {1, 1}).find("after the date before"), std::string::npos);
  EXPECT_NE(refusal({moved(0)}, {1, NAN}).find("after the date before"), std::string::npos);
  EXPECT_EQ(refusal({}, {1}), "");
}

TEST(RequireInOrder, RefusesASurveyOfAnEarlierDay) {
  const auto require = [](const std::vector<std::string>& dates) {
    std::vector<Epoch> surveys(dates.size());
    for (std::size_t i = 0; i < dates.size(); ++i) surveys[i].name = std::to_string(i), surveys[i].date = dates[i];
    requireInOrder(surveys);
  };
  require({"2018-06-01", "2018-06-02", "2023.5"});
  require({"2018-06-01", "in spring", "2023-06-01"});
  require({"2018-06-01", "2018-06-01"});
  for (const std::vector<std::string>& dates : std::vector<std::vector<std::string>>{
           {"2018-06-01", "2023-06-01", "2020-06-01"}, {"in spring", "2023-06-01", "", "2020-06-01"}}) {
    try {
      require(dates);
      FAIL() << "a survey of an earlier day";
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()), "movement: date of " + std::to_string(dates.size() - 1) +
                                               ", 2020-06-01, expected no earlier than that of 1, 2023-06-01: "
                                               "surveys in the order of time");
    }
  }
}

TEST(YearOf, ReadsDatesAndYears) {
  EXPECT_EQ(yearOf("2024-01-01"), 2024.0);
  EXPECT_NEAR(yearOf("2024-12-31"), 2024.0 + 365.0 / 366.0, 1e-9);
  EXPECT_NEAR(yearOf("2023-07-02"), 2023.0 + 182.0 / 365.0, 1e-9);
  EXPECT_EQ(yearOf("2023.5"), 2023.5);
  for (const char* bad : {"", "soon", "2023-02-29", "2023-13-01", "2023-00-10", "2023-05-00", "2023-05-01x", "20",
                          "2010-+1-01", "2010- 1-01", "+201-01-01"}) {
    EXPECT_THROW(yearOf(bad), Error) << bad;
  }
}

}  // namespace tank_datum::trend_test
