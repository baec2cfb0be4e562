#include <gtest/gtest.h>

#include <array>

#include "support/made_feet.h"

namespace tank_datum::foot_levels_test {

using namespace made_feet;

/// A pad of 300 mm round the whole ring, its stations fitted at z = 0 and not settled yet.
struct Ready {
  Foot& foot;
  FootPass pass;
};

Ready ready(MadeFoot& made, double noise = 0.0005) {
  Foot& foot = made.foot();
  const std::size_t count = foot.directions.size();
  Ready result{foot, {}};
  FootProfile& pad = result.pass.sections.whole;
  pad.bin = 0.003, pad.band_from = 0.015, pad.band_to = pad.edge = 0.3;
  pad.blur = 0.006, pad.noise = noise, pad.surface = Surface::Foundation;
  result.pass.sections.stations = count;
  result.pass.priors.slope.assign(count, 0.0);
  result.pass.priors.sigma_slope.assign(count, 0.003);
  result.pass.priors.sigma_bend = 0.003;
  FootFit fit;
  fit.z = 0.0, fit.sigma = 0.0002, fit.middle = 0.15, fit.sigma_slope = 0.002;
  result.pass.fits.assign(count, fit);
  return result;
}

RingProcess level(Ready& r) {
  FootLevels levels = levelStations(r.foot, r.pass);
  r.pass.fits = std::move(levels.fits);
  return std::move(levels.process);
}

/// Stations of so many points each, `together` neighbours 2 mm higher than the next as many.
Ready steps(MadeFoot& made, int count, int together) {
  made.options.wanted_sigma = 1.0;  // every station that stands alone is good enough
  made.options.widest_window = 10.0;
  for (int s = 0; s < 360; ++s) {
    const double z = s / together % 2 == 0 ? 0.002 : 0.0;
    const double only = 0.03 + 0.06 * (s % 5);  // a single point lies now nearer, now further out
    made.addStation(s, count, count > 1 ? 0.02 : only, count > 1 ? 0.28 : only, [z](double) { return z; });
  }
  return ready(made);
}

TEST(LevelStations, AStationOfEightPointsStandsAloneOneOfSevenIsFittedWithItsNeighbour) {
  MadeFoot alone, together;
  Ready eight = steps(alone, 8, 1), seven = steps(together, 7, 1);
  level(eight), level(seven);
  EXPECT_NEAR(eight.pass.fits[10].z, 0.002, 0.0002);
  EXPECT_NEAR(eight.pass.fits[11].z, 0.0, 0.0002);
  EXPECT_NEAR(seven.pass.fits[10].z, seven.pass.fits[11].z, 0.0005);
}

TEST(LevelStations, SparseStationsAreFittedTogetherOverFiveDegreesAtMost) {
  MadeFoot made;
  Ready sparse = steps(made, 1, 5);
  ASSERT_TRUE(level(sparse).valid());
  EXPECT_NEAR(sparse.pass.fits[2].z, 0.002, 0.0003);
  EXPECT_NEAR(sparse.pass.fits[7].z, 0.0, 0.0003);
  EXPECT_NEAR(sparse.pass.fits[12].z, 0.002, 0.0003);
}

TEST(LevelStations, WhereEightPointsLieOnOneSideOfAStationAndNoneBeyondSomethingEndsAtIt) {
  for (const int count : {7, 8}) {
    MadeFoot made;
    for (int s = 0; s < 360; ++s) {
      if (s != 50 && s != 51) made.addStation(s, 12, 0.02, 0.28, [](double) { return 0.0; });
    }
    for (int i = 0; i < count; ++i) made.add((50 - 0.4) * made.step(), 0.03 + 0.03 * i, 0.0);
    Ready one_sided = ready(made);
    level(one_sided);
    EXPECT_EQ(one_sided.pass.fits[50].valid(), count < 8) << count;
  }
}

TEST(LevelStations, ARowThatMissesHalfAStationEndsNothing) {
  MadeFoot made;
  for (int s = 0; s < 360; ++s) {
    if (s != 50) made.addStation(s, 12, 0.02, 0.28, [](double) { return 0.0; });
  }
  for (int i = 0; i < 8; ++i) made.add((50 - 0.4) * made.step(), 0.03 + 0.03 * i, 0.0);
  Ready one_sided = ready(made);
  level(one_sided);
  EXPECT_TRUE(one_sided.pass.fits[50].valid());
}

TEST(LevelStations, AStationLeansOnTwentyOthersAtMost) {
  MadeFoot made;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  made.addAll(10, 0.02, 0.28, [&](double) { return 0.02 * normal(random); });
  Ready noisy = ready(made, 0.02);
  noisy.pass.priors.sigma_slope.assign(360, 1e-4);
  ASSERT_TRUE(level(noisy).valid());
  double widest = 0.0;
  for (const FootFit& fit : noisy.pass.fits) widest = std::max(widest, fit.half_width / noisy.foot.half_step);
  EXPECT_NEAR(widest, 20.0, 1e-9);
}

TEST(LevelStations, ASlopeThatIsSettledIsLearntNoFurtherThanATenthOfAMillimetreAMetre) {
  // without noise but for a slope of 0.2 mm a metre, seen as well as it is believed not to be there
  MadeFoot made;
  made.options.wanted_sigma = 1.0;
  made.addAll(12, 0.02, 0.28, [](double d) { return 0.0002 * d; });
  Ready settled = ready(made, 2.7e-5);
  settled.pass.priors.settled = true;
  level(settled);
  const double middle = 0.15, left = settled.pass.fits[10].z / (0.0002 * middle);
  EXPECT_GT(left, 0.3);
  EXPECT_LT(left, 0.7);
}

TEST(LevelStations, WhereSlopesAreUnevenStationsAreKnownNoBetterThanThose) {
  const auto sigma = [](double uneven) {
    MadeFoot made;
    made.addAll(12, 0.02, 0.28, [](double) { return 0.0; });
    Ready settled = ready(made);
    settled.pass.priors.settled = true;
    settled.pass.priors.uneven = uneven;
    level(settled);
    return settled.pass.fits[10].sigma;
  };
  EXPECT_NEAR(sigma(0.01), 0.01 * 0.15, 0.0003);
  EXPECT_LT(sigma(0.0), 0.0006);
}

/// Beams lift a level lip beside the shell and lower it beside the edge. Of every station's rows one lies beside the
/// shell here, one beside the edge there.
TEST(LevelStations, StationsWhoseRowsLieBesideTheShellOrTheEdgeAreLevelledWithoutWhatBlendsDoThere) {
  constexpr double kSlope = -0.06, kLevelAt = 0.035;
  MadeFoot made;
  made.options.wanted_sigma = 1.0;
  for (int s = 0; s < 360; ++s) {
    const double row = s % 20 < 10 ? 0.018 : 0.050;
    made.addStation(s, 12, row - 0.002, row + 0.002, [](double d) { return kSlope * (d - kLevelAt); });
  }
  const auto fitsOf = [&](double sigma) {
    Ready r = ready(made);
    FootProfile& lip = r.pass.sections.whole;
    lip.band_to = 0.055, lip.edge = 0.06, lip.blur = 1e-6;
    r.pass.priors.settled = true;
    r.pass.priors.blends.slope.assign(360, sigma > 0.0 ? kSlope : 0.0);
    r.pass.priors.blends.sigma.assign(360, sigma);
    r.pass.priors.blends.level_at = kLevelAt;
    level(r);
    return std::array<FootFit, 2>{r.pass.fits[4], r.pass.fits[14]};
  };
  const auto blended = fitsOf(0.0), fits = fitsOf(0.01);
  EXPECT_GT(blended[0].z - blended[1].z, 0.0015);
  EXPECT_NEAR(fits[0].z, 0.0, 0.0001);
  EXPECT_NEAR(fits[1].z, 0.0, 0.0001);
  const BlendedLip lip{{kSlope}, {0.01}, kLevelAt};
  FootFit beside;
  beside.z = 0.001, beside.sigma = 0.0003, beside.middle = 0.075;
  EXPECT_NEAR(lip.without(beside, 0).z, 0.001 - 0.04 * kSlope, 1e-12);
  EXPECT_NEAR(lip.without(beside, 0).sigma, 0.0005, 1e-12);
}

/// The fit of station 100 of a quiet ring where so many neighbours lie 8 mm lower, and their windows say so; and
/// where one does, with the shell seen down to it or not.
FootFit fitOfDip(int wide, bool shell) {
  MadeFoot made;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto dips = [wide](int s) { return std::abs(s - 100) <= wide / 2; };
  for (int s = 0; s < 360; ++s) {
    const double z = dips(s) ? -0.008 : 0.0;
    made.addStation(s, 12, 0.02, 0.28, [&](double) { return z + 0.0005 * normal(random); });
    for (int i = 0; shell && i < 12; ++i) made.add(s * made.step(), 0.0, z + 0.001 * (i + 1));
  }
  Ready r = ready(made);
  for (int s = 0; s < 360; ++s)
    if (dips(s)) r.pass.fits[static_cast<std::size_t>(s)].z = -0.008;
  level(r);
  return r.pass.fits[100];
}

TEST(LevelStations, WhereNoneStandAloneThoseBetweenArcsOfSoilAreToldByTheirWindows) {
  const auto stands = [](double height, double half_width) {  // of a station between two arcs
    MadeFoot made;
    Ready r = ready(made);
    r.pass.outliers.reasons.assign(360, Unmeasured::None);
    for (const std::size_t i : {100U, 101U, 102U, 106U, 107U}) r.pass.outliers.reasons[i] = Unmeasured::OtherSurface;
    for (FootFit& fit : r.pass.fits) fit.half_width = half_width;
    for (std::size_t i = 103; i < 106; ++i) r.pass.fits[i].z = height;
    EXPECT_FALSE(level(r).valid());
    EXPECT_TRUE(r.pass.fits[0].valid());
    return r.pass.fits[104].valid();
  };
  MadeFoot made;
  const double half = made.foot().half_step;
  EXPECT_FALSE(stands(0.06, half));
  EXPECT_TRUE(stands(0.0, half));
  EXPECT_TRUE(stands(-0.06, half));
  EXPECT_FALSE(stands(0.0016, half));
  EXPECT_TRUE(stands(0.0016, 64.0 * half));  // which have most of their points in common
}

TEST(LevelStations, NeighboursThatLieLowerTogetherKeepTheLevelOfTheirOwnWindows) {
  EXPECT_NEAR(fitOfDip(3, false).z, -0.008, 0.0004);
  EXPECT_NEAR(fitOfDip(5, false).z, -0.008, 0.0004);
}

TEST(LevelStations, AStationThatLiesLowerAloneIsDoubtedButWhereTheShellGoesDownToIt) {
  const FootFit alone = fitOfDip(1, false), seen = fitOfDip(1, true);
  EXPECT_NEAR(alone.z, -0.008, 1e-9);
  EXPECT_NEAR(alone.sigma, kEither * 0.008, 0.0003);  // it may be as the others say
  EXPECT_NEAR(seen.z, -0.008, 1e-9);
  EXPECT_LT(seen.sigma, 0.001);
}

TEST(LevelStations, AQuietDatumMayStillDipByAHundredthOfTheReach) {
  MadeFoot made;
  made.addAll(12, 0.02, 0.28, [](double) { return 0.0; });
  Ready quiet = ready(made);
  EXPECT_NEAR(level(quiet).amplitude, 0.01 * kReach, 1e-12);
}

}  // namespace tank_datum::foot_levels_test
