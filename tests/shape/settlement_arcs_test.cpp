#include "shape/settlement_arcs.h"

#include <gtest/gtest.h>

#include "shape/out_of_plane.h"
#include "support/made_surveys.h"

namespace tank_datum::settlement_arcs_test {

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
  const OutOfPlane fit = fitOutOfPlane(stations, 30.0);
  ASSERT_TRUE(fit.valid());
  stations = withParts(stations, fit.stations);
  const auto arcs = settlementArcs(stations, 30.0);
  ASSERT_EQ(arcs.size(), 4U);
  for (const SettlementArc& arc : arcs) EXPECT_NEAR(arc.largest.value, 0.01, 7e-4);
}

TEST(SettlementArcs, OfDenseStationsWithoutARegressionAreThoseOfSurveyPoints) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto flat = survey(noisy(std::vector<double>(360, 0.0), 0.001, seed), 7.5, 0.001);
    for (const SettlementArc& arc : settlementArcs(flat, 7.5)) {
      EXPECT_LT(arc.largest.value / arc.length, 3e-4) << "K 28.7, H 15 m, 235 MPa: 2.7e-3 is allowed";
      EXPECT_LT(arc.largest.value, 0.0006) << "the mean of 23 stations";
    }
  }
  const auto bent = survey(wave(360, [](double a) { return 0.01 * std::cos(2 * a); }), 7.5);
  const auto arcs = settlementArcs(bent, 7.5);
  ASSERT_EQ(arcs.size(), 4U);
  // eight points, means over an eighth of a wave on either side: sin(pi/8) / (pi/8) of the crest
  for (const SettlementArc& arc : arcs) EXPECT_NEAR(arc.largest.value, 0.00974, 3e-5);
}

TEST(SettlementArcs, OfAFoldAreHalvesOfTheCircumference) {
  std::vector<double> z(16, 0.0);
  const auto stations = [&] {
    auto all = survey(z, 20.0);
    for (std::size_t i = 0; i < 16; ++i) all[i].u = i < 5 ? 0.01 : -0.003;  // positive over five stations alone
    return all;
  }();
  const auto arcs = settlementArcs(stations, 20.0);
  ASSERT_EQ(arcs.size(), 2U);
  for (const SettlementArc& arc : arcs) EXPECT_NEAR(arc.length, kTurn * 10.0, 1e-9);
}

TEST(SettlementArcs, NoneWithoutASignChange) {
  EXPECT_TRUE(settlementArcs(survey(std::vector<double>(16, 2.0), 20.0), 20.0).empty());
  EXPECT_TRUE(settlementArcs({}, 20.0).empty());
}

}  // namespace tank_datum::settlement_arcs_test
