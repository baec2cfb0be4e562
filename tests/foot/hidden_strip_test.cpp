#include "foot/hidden_strip.h"

#include <gtest/gtest.h>

#include "support/made_feet.h"

namespace tank_datum {
namespace {

using namespace made_feet;

/// Twenty strips: so many of each number of points, from the shell outwards, and none beyond.
std::vector<std::size_t> strips(const std::vector<std::pair<int, std::size_t>>& runs) {
  std::vector<std::size_t> points;
  for (const auto& [count, each] : runs) points.insert(points.end(), static_cast<std::size_t>(count), each);
  points.resize(20, 0);
  return points;
}

TEST(ThinStrips, OfASurfaceThatIsSeenUpToTheShellNoneAre) {
  EXPECT_EQ(thinStrips(strips({{20, 1000}})), 0U);
  EXPECT_EQ(thinStrips(strips({{5, 1000}, {1, 2000}})), 0U);  // a lip and its face
  EXPECT_EQ(thinStrips(strips({})), 0U);
}

TEST(ThinStrips, OfACrownThoseBeforeItAre) {
  EXPECT_EQ(thinStrips(strips({{7, 10}, {8, 100}, {2, 1000}})), 7U);
  EXPECT_EQ(thinStrips(strips({{7, 0}, {8, 100}, {2, 1000}})), 7U);
}

TEST(ThinStrips, HaveLessThanTwoThirdsOfThePoints) {
  EXPECT_EQ(thinStrips(strips({{5, 6100}, {15, 10000}})), 5U);
  EXPECT_EQ(thinStrips(strips({{5, 6700}, {15, 10000}})), 0U);
}

TEST(ThinStrips, AreNoneWhereOneOfThemIsDense) {
  EXPECT_EQ(thinStrips(strips({{1, 7000}, {4, 0}, {15, 10000}})), 0U);  // a plate of which all but a strip is hidden
  EXPECT_EQ(thinStrips(strips({{1, 6000}, {4, 0}, {15, 10000}})), 5U);
}

TEST(ThinStrips, AreSoBeyondTwoStandardDeviations) {
  EXPECT_EQ(thinStrips(strips({{3, 4}, {17, 10}})), 3U);
  EXPECT_EQ(thinStrips(strips({{1, 5}, {2, 4}, {17, 10}})), 0U);
}

TEST(ThinStrips, AreThreeAtLeast) {
  EXPECT_EQ(thinStrips(strips({{2, 10}, {18, 1000}})), 0U);
  EXPECT_EQ(thinStrips(strips({{3, 10}, {17, 1000}})), 3U);
}

TEST(ThinStrips, AreComparedWithSixBeyond) {
  EXPECT_EQ(thinStrips(strips({{3, 100}, {2, 1000}, {15, 100}})), 0U);  // the upright face of something
  EXPECT_EQ(thinStrips(strips({{3, 10}, {5, 1000}})), 3U);              // a narrow crown
}

/// A pass whose fits all stand upon z = 0, or that of one station only.
FootPass passUpon(std::optional<std::size_t> station = {}) {
  FootFit fit;
  fit.z = fit.slope = 0.0, fit.sigma = 0.0002;
  FootPass pass;
  pass.fits.resize(360);
  for (std::size_t i = 0; i < pass.fits.size(); ++i) {
    if (i == station.value_or(i)) pass.fits[i] = fit;
  }
  pass.outliers.reasons.assign(360, Unmeasured::None);
  pass.priors.slope.assign(360, 0.0);
  pass.sections.whole.noise = 0.0004;
  return pass;
}

double level(double /*d*/) { return 0.0; }

/// How far a surface is hidden that is seen from some way out on, a point a millimetre, and that lies so high there.
double hiddenBefore(double from, double height = 0.0) {
  MadeFoot made;
  made.addAll(20, 0.013, from, level);
  made.addAll(160, from, from + 0.16, [height](double) { return height; });
  return hiddenBesideShell(made.foot(), passUpon(), std::vector<double>(360, 0.0));
}

TEST(HiddenBesideShell, IsWhatLiesBeforeACrown) {
  EXPECT_NEAR(hiddenBefore(0.093), 0.093, 1e-9);
  EXPECT_EQ(hiddenBefore(0.023), 0.0);  // a strip as narrow as a weld
}

TEST(HiddenBesideShell, IsLookedForAsFarAsThreeTenthsOfTheReach) {
  EXPECT_NEAR(hiddenBefore(0.143), 0.143, 1e-9);
  EXPECT_EQ(hiddenBefore(0.193), 0.0);
}

TEST(HiddenBesideShell, IsOfTheSurfaceThatStationsLieOn) {
  EXPECT_GT(hiddenBefore(0.093, 0.0022), 0.0);
  EXPECT_EQ(hiddenBefore(0.093, 0.0030), 0.0);
}

/// Whether it is hidden about one station that alone stands and sees all of it, where another sees most beyond only.
bool isHiddenAbout(int standing, int other) {
  MadeFoot made;
  made.addStation(standing, 150, 0.013, 0.163, level);
  made.addStation(other, 700, 0.093, 0.163, level);
  const FootPass pass = passUpon(static_cast<std::size_t>(standing));
  return hiddenBesideShell(made.foot(), pass, std::vector<double>(360, 0.0)) > 0.0;
}

TEST(HiddenBesideShell, LooksAtStationsWithinThreeDegreesOfThoseThatStand) {
  EXPECT_TRUE(isHiddenAbout(1, 358));
  EXPECT_FALSE(isHiddenAbout(1, 357));
}

TEST(HiddenBesideShell, LeavesOutWhatIsRefused) {
  MadeFoot made;
  made.addAll(160, 0.093, 0.253, level);
  FootPass pass = passUpon();
  pass.outliers.reasons.assign(360, Unmeasured::OtherSurface);
  EXPECT_EQ(hiddenBesideShell(made.foot(), pass, std::vector<double>(360, 0.0)), 0.0);
}

}  // namespace
}  // namespace tank_datum
