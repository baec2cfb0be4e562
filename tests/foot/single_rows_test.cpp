#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "foot/foot_patches.h"
#include "foot/foot_roughness.h"
#include "foot/slanting_beams.h"
#include "support/level_fits.h"
#include "support/made_feet.h"
#include "support/rough_surface.h"

namespace tank_datum::single_rows_test {

using made_feet::levelOf, made_feet::RoughSurface;

constexpr double kSteepness = 0.07, kPlumb = std::numeric_limits<double>::infinity();

FootProfile lip() {
  FootProfile profile;
  profile.band_from = 0.015, profile.band_to = profile.edge = 0.054;
  profile.blur = 0.004, profile.noise = 0.0005;
  return profile;
}

/// Stations of a lip on which one row of the scan lies, which creeps out by 10 mm. Its points err, along the rays.
std::vector<FittedPoints> stationsOfOneRow(double known) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<FittedPoints> all;
  for (int k = 0; k < 200; ++k) {
    std::vector<FootPoint> points;
    for (int i = 0; i < 60; ++i) {
      const double z = 0.0006 * normal(random), d = 0.03 + 0.01 * i / 60.0;
      points.push_back({0.009 * (i - 30), d + z / kSteepness, z});
    }
    all.push_back(levelOf(std::move(points), 0.0006, known));
  }
  return all;
}

TEST(SharedRoughness, OfASingleRowsPointsThatErrAloneIsNone) {
  EXPECT_LT(std::sqrt(sharedRoughness(stationsOfOneRow(kSteepness), lip())), 4e-5);
  EXPECT_GT(std::sqrt(sharedRoughness(stationsOfOneRow(kPlumb), lip())), 2e-4) << "parted by their heights";
}

/// A station whose thirds or sixths are raised, each with its points.
FittedPoints raised(const std::vector<double>& heights, const std::vector<int>& points, double noise) {
  std::vector<FootPoint> all;
  const double width = 0.039 / static_cast<double>(heights.size());
  for (std::size_t k = 0; k < heights.size(); ++k) {
    for (int i = 0; i < points[k]; ++i)
      all.push_back({0.0, 0.015 + width * (static_cast<double>(k) + 0.5), heights[k]});
  }
  return levelOf(std::move(all), noise, kPlumb);
}

TEST(SharedRoughness, APartCountsForItsPoints) {
  const double a = 0.001, noise = 0.0005;
  const double even = sharedRoughness({raised({a, 0.0, -a}, {12, 12, 12}, noise)}, lip());
  EXPECT_NEAR(even, (24.0 * a * a - 2.0 * noise * noise) / 24.0 / 3.0, 1e-12);
  const double one = sharedRoughness({raised({a, 0.0, 0.0}, {1, 17, 18}, noise)}, lip());
  EXPECT_NEAR(one, (35.0 / 36.0 * a * a - 2.0 * noise * noise) / (36.0 - 614.0 / 36.0) / 3.0, 1e-12);
}

TEST(SharedRoughness, OfSixthsOnlyWhatIsMoreThanTheirStandardErrorCounts) {
  const double a = 0.001, noise = 0.0003;
  const std::vector<double> heights{a, -a, a, -a, a, -a};  // thirds are level
  const std::vector<int> points(6, 10);
  const double squares = 60.0 * a * a;
  const auto seen = [&](double fits) {
    return squares - 5.0 * noise * noise - std::sqrt(2.0 / (5.0 * fits)) * squares;
  };
  const FittedPoints station = raised(heights, points, noise);
  EXPECT_NEAR(sharedRoughness({station}, lip()), seen(1.0) / 50.0 / 6.0, 1e-12);
  EXPECT_NEAR(sharedRoughness(std::vector<FittedPoints>(50, station), lip()), seen(50.0) / 50.0 / 6.0, 1e-12);
}

TEST(PatchesOf, OfFewWindowsWhatTheyKnowNoBetterThanHowTheirPointsScatterIsNotTold) {
  std::vector<FootPoint> pairs;  // each of two points alike
  for (int i = 0; i < 10; ++i) {
    const int pair = i / 2;
    pairs.push_back({0.02 * pair + 0.002 * (i % 2), 0.02 + 0.013 * (pair % 3), pair % 2 == 0 ? 0.001 : -0.001});
  }
  const FittedPoints window = levelOf(pairs, 0.001, kPlumb);
  EXPECT_EQ(patchesOf({window, window}, lip()).heights, 0.0);
  EXPECT_GT(patchesOf({window, window, window}, lip()).heights, 0.0);
}

/// Windows of a few rows on a rough lip, as of rays that meet bumps farther out.
std::vector<FittedPoints> windowsOfRows(const RoughSurface& rough, double known) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> between(0.0, 1.0);
  FootPrior prior;
  prior.sigma_slope = 0.002, prior.sigma_bend = 0.003;
  std::vector<FittedPoints> all;
  for (int k = 0; k < 300; ++k) {
    std::vector<FootPoint> points;
    const double first = 0.020 * between(random), creeps = 0.02 * (between(random) - 0.5);
    for (const double row : {0.010 + first, 0.030 + first}) {
      for (double t = -0.2; t < 0.2; t += 0.008) {
        const double d = row + creeps * t / 0.2, z = rough(2.0 * k + t, d) + 0.0002 * normal(random);
        points.push_back({t, d + z / kSteepness, z});
      }
    }
    const FootFit fit = fitFoundation(points, lip(), 0.0, prior);
    all.push_back({std::move(points), fit, known});
  }
  return all;
}

TEST(PatchesOf, RowsOnALipAreThoseWhereTheirRaysWouldMeetIt) {
  const RoughSurface surface(0.0005, 0.0125);
  const Roughness seen = patchesOf(windowsOfRows(surface, kSteepness), lip());
  EXPECT_NEAR(seen.heights, 0.0005, 0.00006);
  EXPECT_NEAR(seen.length, 0.0125, 0.001);
  EXPECT_LT(patchesOf(windowsOfRows(surface, kPlumb), lip()).heights, 0.00035) << "alike as d makes them";
}

TEST(PooledSteepness, IsOfWindowsTogetherAlsoWhereOneLooksFlatter) {
  const std::vector<RayCounts> few{{4, 100, 200, 0}, {40, 1000, 200, 0}, {9, 200, 200, 0}}, one{{50, 1250, 200, 0}, {}};
  EXPECT_NEAR(pooledSteepness(few, 0.5)[0], 1300.0 * 0.2 / 600.0, 1e-12);
  EXPECT_NEAR(pooledSteepness(one, 0.5)[0], 1250.0 * 0.2 / 200.0, 1e-12);
}

TEST(FootPriors, RaysThatAreNotKnownArePlumb) {
  FootPriors priors;
  EXPECT_EQ(priors.steepnessAt(1), kPlumb);
  priors.steepness = {0.05, 0.0};
  EXPECT_EQ(priors.steepnessAt(0), 0.05);
  EXPECT_EQ(priors.steepnessAt(1), kPlumb);
}

/// Stations of 10 m radius, each with a row of 60 points on a lip that err along the rays, and so many on the shell.
struct LipOfRows {
  made_feet::MadeFoot made;
  FootSections sections;

  LipOfRows() {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int s = 0; s < 360; ++s) {
      for (int i = 0; i < 60; ++i) {
        const double z = 0.0006 * normal(random), azimuth = (s + (i - 29.5) / 61.0) * made.step();
        made.add(azimuth, 0.03 + 0.01 * i / 60.0 + z / kSteepness, z);
        made.add(azimuth, 0.0, 0.051 + 0.198 * i / 60.0);
      }
    }
    sections.whole = lip();
    sections.whole.bin = 0.003, sections.whole.surface = Surface::AnnularPlate;
    for (int bin = 0; bin < 100; ++bin) sections.whole.height.push_back(bin < 18 ? 0.0 : -0.01);
    sections.stations = 360;
  }

  FootPass pass() {
    FootPass pass;
    pass.sections = sections;
    const FootElevations level{{}, std::vector<double>(360, 0.0), std::vector<bool>(360, true)};
    pass.priors = learnPriors(made.foot(), level, sections);
    FootFit fit;
    fit.z = 0.0, fit.sigma = 0.001, fit.middle = 0.035;
    pass.fits.assign(360, fit);
    pass.outliers.reasons.assign(360, Unmeasured::None);
    return pass;
  }
};

TEST(LearnPriors, HowRaysSlantToALipIsReadFromItsPointsAndTheShells) {
  LipOfRows lip_of_rows;
  const FootPass pass = lip_of_rows.pass();
  for (const std::size_t station : {0U, 101U, 359U}) {
    EXPECT_NEAR(pass.priors.steepnessAt(station), 60.0 / 0.039 * 0.2 / 60.0, 0.5) << station;
  }
}

TEST(PatchWindows, KnowHowRaysSlant) {
  LipOfRows lip_of_rows;
  FootPass pass = lip_of_rows.pass();
  pass.priors.steepness.assign(360, kSteepness);
  EXPECT_EQ(patchWindows(lip_of_rows.made.foot(), pass)[20].steepness, kSteepness);
}

TEST(LevelStations, OfSingleRowsWhosePointsErrAloneHaveNoRoughness) {
  LipOfRows lip_of_rows;
  const auto sigmaOf = [&](double steepness) {
    lip_of_rows.made.options.wanted_sigma = 1.0;  // of the station alone
    FootPass pass = lip_of_rows.pass();
    pass.priors.slope.assign(360, 0.0), pass.priors.steepness.assign(360, steepness);
    return levelStations(lip_of_rows.made.foot(), pass).fits[100].sigma;
  };
  EXPECT_LT(sigmaOf(kSteepness), 0.6 * sigmaOf(0.0));
}

}  // namespace tank_datum::single_rows_test
