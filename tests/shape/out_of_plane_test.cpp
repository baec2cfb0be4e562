#include "shape/out_of_plane.h"

#include <gtest/gtest.h>

#include "stations/stations.h"
#include "support/made_surveys.h"

namespace tank_datum::out_of_plane_test {

using namespace made_surveys;

/// Six waves of known amplitude and crest on a tilted tank.
double sixWaves(double a) {
  double z = 3.0;
  for (int n = 1; n <= 6; ++n) z += 0.001 * n * std::cos(n * (a - 0.1 * n));
  return z;
}

void blank(std::vector<double>& z, std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < first + count; ++i) z[i % z.size()] = NAN;
}

/// The regression, put into the stations.
OutOfPlane takeBending(std::vector<Station>& stations, double radius) {
  const OutOfPlane fit = fitOutOfPlane(stations, radius);
  stations = withParts(stations, fit.stations);
  return fit;
}

TEST(HarmonicsOf, FindsExactWavesWhateverTheNumberOfStations) {
  for (const std::size_t count : {36U, 90U, 360U, 720U}) {
    const auto harmonics = harmonicsOf(survey(wave(count, sixWaves), 30.0), 30.0);
    ASSERT_GE(harmonics.size(), 7U) << count;
    EXPECT_NEAR(harmonics[0].amplitude, 3.0, 1e-9);
    EXPECT_TRUE(std::isnan(harmonics[0].crest));
    for (int n = 1; n <= 6; ++n) {
      const Harmonic& h = harmonics[static_cast<std::size_t>(n)];
      EXPECT_EQ(h.n, n);
      EXPECT_NEAR(h.amplitude, 0.001 * n, 1e-9) << count;
      EXPECT_NEAR(h.crest, 0.1 * n, 1e-6);
    }
  }
}

TEST(HarmonicsOf, GoesToHalfWavesOfTwentyFeetAndSixAtLeast) {
  EXPECT_EQ(harmonicsOf(survey(wave(360, sixWaves), 30.0), 30.0).size(), 16U);  // pi 30 / 6.096 = 15.5
  EXPECT_EQ(harmonicsOf(survey(wave(360, sixWaves), 5.0), 5.0).size(), 7U);
  EXPECT_EQ(harmonicsOf(survey(wave(16, sixWaves), 30.0), 30.0).size(), 4U);  // four stations a wave
  EXPECT_TRUE(harmonicsOf(survey({1, NAN, NAN, NAN, 2, NAN, NAN, NAN}, 30.0), 30.0).empty());
}

TEST(HarmonicsOf, AreFoundBesideAGapToo) {
  std::vector<double> z = wave(360, sixWaves);
  blank(z, 330, 60);
  const auto harmonics = harmonicsOf(survey(z, 30.0), 30.0);
  for (int n = 1; n <= 6; ++n) EXPECT_NEAR(harmonics[static_cast<std::size_t>(n)].amplitude, 0.001 * n, 4e-5) << n;
}

TEST(HarmonicsOf, TwoSigmaHoldTheTruthBesideAGap) {
  int held = 0, all = 0;
  double sigmas = 0.0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::vector<double> z = noisy(wave(360, sixWaves), 0.0005, seed);
    blank(z, 100, 60);
    const auto harmonics = harmonicsOf(survey(z, 30.0, 0.0005), 30.0);
    for (int n = 1; n <= 6; ++n, ++all) {
      const Harmonic& h = harmonics[static_cast<std::size_t>(n)];
      held += std::abs(h.amplitude - 0.001 * n) <= 2.0 * h.sigma;
      sigmas += h.sigma / 180;
    }
  }
  EXPECT_GE(held, 0.93 * all);
  EXPECT_LT(sigmas, 0.001) << "standard errors that promise too little";
}

TEST(HarmonicsOf, SigmaGrowsWithTheCorrelationOfNeighbours) {
  std::vector<double> z = noisy(wave(360, sixWaves), 0.001, 1);
  const double apart = harmonicsOf(survey(z, 30.0, 0.001), 30.0)[2].sigma;
  EXPECT_NEAR(apart, 0.001 * std::sqrt(2.0 / 360.0), 0.15e-4);
  std::vector<double> smooth(360);
  const std::vector<double> white = noisy(std::vector<double>(360, 0.0), 0.001, 2);
  for (std::size_t i = 0; i < 360; ++i) {
    for (std::size_t j = 0; j < 4; ++j) smooth[i] += 0.5 * white[(i + j) % 360];  // the same scatter, shared
  }
  EXPECT_NEAR(harmonicsOf(survey(smooth, 30.0, 0.001), 30.0)[2].sigma / apart, 2.0, 0.4);
}

TEST(FitOutOfPlane, FindsTheCurvatureOfAWave) {
  auto stations = survey(wave(360, [](double a) { return 1.0 + 0.02 * std::cos(a) + 0.006 * std::cos(3 * a); }), 30.0);
  const OutOfPlane fit = takeBending(stations, 30.0);
  ASSERT_TRUE(fit.valid()) << fit.message;
  EXPECT_GE(fit.order, 4);
  EXPECT_NEAR(fit.max_u, 0.006, 1e-9);
  EXPECT_NEAR(fit.max_curvature, 0.006 * 9 / 900, 1e-9);
  EXPECT_NEAR(fit.adjusted_r2, 1.0, 1e-6);
  EXPECT_NEAR(fit.rms, 0.0, 1e-9);
  for (const Station& s : stations) {
    EXPECT_NEAR(s.u_fit, 0.006 * std::cos(3 * s.azimuth), 1e-9);
    EXPECT_NEAR(s.curvature, -0.006 * 9 / 900 * std::cos(3 * s.azimuth), 1e-9);
  }
}

TEST(FitOutOfPlane, RefusesWavesThatAGapHides) {
  const auto fitBeside = [](std::size_t gap) {
    std::vector<double> z = wave(360, sixWaves);
    blank(z, 60, gap);
    auto stations = survey(z, 30.0);
    const OutOfPlane fit = takeBending(stations, 30.0);
    EXPECT_EQ(std::isfinite(stations[0].curvature), fit.valid());
    EXPECT_GT(fit.max_u, 0.0);
    return fit;
  };
  EXPECT_TRUE(fitBeside(85).valid());
  for (const std::size_t gap : {100U, 240U}) {
    EXPECT_FALSE(fitBeside(gap).valid());
    EXPECT_NE(fitBeside(gap).message.find("cannot be told apart"), std::string::npos);
  }
}

TEST(FitOutOfPlane, OfOneWaveAlonePassesOverTheOrdersBelowIt) {
  for (const int n : {6, 7, 8, 12}) {
    const auto bent = [n](double a) { return 0.010 * std::cos(n * a); };
    auto stations = survey(noisy(wave(360, bent), 0.0002, 5), 30.0, 0.0002);
    const OutOfPlane fit = takeBending(stations, 30.0);
    EXPECT_GE(fit.order, n);
    EXPECT_LE(fit.order, 15);
    EXPECT_NEAR(fit.max_curvature / (0.010 * n * n / 900.0), 1.0, 0.05) << n;
  }
}

TEST(FitOutOfPlane, StopsWhereNoFurtherWaveExplainsMore) {
  std::vector<double> z = wave(360, [](double a) { return 0.01 * std::cos(2 * a) + 0.002 * std::cos(9 * a); });
  for (int n = 20; n <= 40; ++n) {  // scatter without any of the waves that are tried
    for (std::size_t i = 0; i < 360; ++i) z[i] += 1e-4 * std::cos(n * (static_cast<double>(i) * kDegree + 0.7 * n));
  }
  auto stations = survey(z, 30.0, 1e-4);
  EXPECT_EQ(fitOutOfPlane(stations, 30.0).order, 9);
}

TEST(FitOutOfPlane, StandardErrorOfTheCurvatureForetellsItsScatter) {
  double squares = 0, foretold = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    auto stations =
        survey(noisy(wave(360, [](double a) { return 0.005 * std::cos(2 * a); }), 0.001, seed), 30.0, 0.001);
    takeBending(stations, 30.0);
    const Station& s = stations[45];
    squares += std::pow(s.curvature - 0.0, 2) / 100;  // 4 / 900 * cos(90 deg)
    foretold += s.sigma_curvature * s.sigma_curvature / 100;
  }
  EXPECT_NEAR(std::sqrt(squares / foretold), 1.0, 0.3);
}

TEST(FitOutOfPlane, SaysWhyItIsNot) {
  auto few = survey(wave(64, sixWaves), 30.0);
  EXPECT_FALSE(fitOutOfPlane(few, 30.0).valid());
  EXPECT_NE(fitOutOfPlane(few, 30.0).message.find("64 stations measured"), std::string::npos);
  EXPECT_TRUE(std::isnan(few[0].u_fit));
  EXPECT_GT(fitOutOfPlane(few, 30.0).max_u, 0.005);
  auto small = survey(wave(360, sixWaves), 9.0);
  EXPECT_NE(fitOutOfPlane(small, 9.0).message.find("18.6 m"), std::string::npos);
  std::vector<Station> none;
  EXPECT_FALSE(fitOutOfPlane(none, 30.0).valid());
}

TEST(LongestGap, IsAnArc) {
  std::vector<double> z(360, 0.0);
  EXPECT_NEAR(longestGap(survey(z, 30.0), 30.0), 30.0 * kDegree, 1e-9);
  blank(z, 350, 29);  // over the zero azimuth
  EXPECT_NEAR(longestGap(survey(z, 30.0), 30.0), 30.0 * 30.0 * kDegree, 1e-9);
  EXPECT_NEAR(longestGap(emptyStations({}), 30.0), kTurn * 30.0, 1e-9);
  auto bridged = survey(std::vector<double>(360, 0.0), 30.0);
  for (std::size_t i = 10; i < 20; ++i) bridged[i].flag = StationFlag::Interpolated;
  EXPECT_NEAR(longestGap(bridged, 30.0), 30.0 * 11.0 * kDegree, 1e-9) << "no bridge shows what is there";
}

}  // namespace tank_datum::out_of_plane_test
