#include "tank_datum/shape/settlement_arcs.h"

#include <gtest/gtest.h>

#include "support/made_surveys.h"
#include "tank_datum/shape/out_of_plane.h"

namespace tank_datum {
namespace {

using namespace made_surveys;

TEST(SettlementArcs, OfAWaveAreItsHalves) {
  const auto arcs = settlementArcs(survey(wave(48, [](double a) { return 0.01 * std::cos(3 * a + 0.2); }), 20.0), 20.0);
  ASSERT_EQ(arcs.size(), 6U);
  double sum = 0;
  for (const SettlementArc& arc : arcs) {
    EXPECT_NEAR(arc.length, kTurn * 20.0 / 6.0, 0.1);
    EXPECT_NEAR(arc.largest.value, 0.01, 2e-4);
    sum += arc.length;
  }
  EXPECT_NEAR(sum, kTurn * 20.0, 1e-9);
}

TEST(SettlementArcs, OfDenseStationsAreThoseOfTheRegression) {
  auto stations = survey(noisy(wave(360, [](double a) { return 0.01 * std::cos(2 * a); }), 0.001, 3), 30.0, 0.001);
  EXPECT_GT(settlementArcs(stations, 30.0).size(), 10U);  // noise crosses zero as well
  ASSERT_TRUE(fitOutOfPlane(stations, 30.0).valid());
  const auto arcs = settlementArcs(stations, 30.0);
  ASSERT_EQ(arcs.size(), 4U);
  for (const SettlementArc& arc : arcs) EXPECT_NEAR(arc.largest.value, 0.01, 5e-4);
}

TEST(SettlementArcs, NoneWithoutASignChange) {
  EXPECT_TRUE(settlementArcs(survey(std::vector<double>(16, 2.0), 20.0), 20.0).empty());
  EXPECT_TRUE(settlementArcs({}, 20.0).empty());
}

}  // namespace
}  // namespace tank_datum
