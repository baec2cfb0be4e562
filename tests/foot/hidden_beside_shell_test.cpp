#include <gtest/gtest.h>

#include "foot/hidden_strip.h"
#include "support/made_feet.h"

namespace tank_datum::hidden_beside_shell_test {

using namespace made_feet;

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
double hiddenBefore(double from, double height = 0.001) {
  MadeFoot made;
  made.addAll(30, 0.013, from, [](double) { return -0.001; });
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

/// Whether a surface is hidden of which little is seen but for points close to the shell, as many of which lie so much
/// higher.
bool isHiddenBesideNoise(double height) {
  MadeFoot made;
  made.addAll(30, 0.013, 0.093, [](double) { return -0.001; });
  made.addAll(160, 0.093, 0.253, [](double) { return 0.001; });
  made.addAll(8, 0.013, 0.023, level);
  made.addAll(8, 0.013, 0.023, [height](double) { return height; });
  return hiddenBesideShell(made.foot(), passUpon(), std::vector<double>(360, 0.0)) > 0.0;
}

TEST(HiddenBesideShell, ShowsWhatIsTheShellsByWhatLiesAsFarAboveTheSurface) {
  EXPECT_TRUE(isHiddenBesideNoise(0.0028));
  EXPECT_TRUE(isHiddenBesideNoise(0.0076));
  EXPECT_FALSE(isHiddenBesideNoise(0.0080));
  EXPECT_FALSE(isHiddenBesideNoise(-0.0040));
}

/// Whether a surface half of whose points beside the shell are lost is hidden, where the shell goes on below it.
bool isHiddenBeforeShell(double off) {
  MadeFoot made;
  made.addAll(35, 0.013, 0.083, level);
  made.addAll(70, 0.083, 0.153, level);
  for (int station = 0; station < 360; ++station) {
    for (int i = 0; i < 20; ++i) made.add(station * made.step(), off, 0.001 * (i - 9.5));
  }
  return hiddenBesideShell(made.foot(), passUpon(), std::vector<double>(360, 0.0)) > 0.0;
}

TEST(HiddenBesideShell, IsWhatTheShellGoesOnBelow) {
  EXPECT_TRUE(isHiddenBeforeShell(0.0018));
  EXPECT_FALSE(isHiddenBeforeShell(0.0022));
}

/// Whether it is hidden about one station that alone stands and sees all of it, where another sees most beyond only.
bool isHiddenAbout(int standing, int other) {
  MadeFoot made;
  made.addStation(standing, 150, 0.013, 0.163, [](double d) { return d < 0.093 ? -0.001 : 0.001; });
  made.addStation(other, 700, 0.093, 0.163, [](double) { return 0.001; });
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

}  // namespace tank_datum::hidden_beside_shell_test
