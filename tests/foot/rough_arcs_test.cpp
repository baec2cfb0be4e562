#include "foot/rough_arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "foot/foot_heaps.h"
#include "support/made_feet.h"

namespace tank_datum::rough_arcs_test {

using namespace made_feet;

/// Scatter of a foundation's points, and of those about the shell [m].
constexpr double kUsual = 0.0005, kShellNoise = 0.001;
const double kMost = std::sqrt(3.0 * kUsual * kUsual + kShellNoise * kShellNoise);

/// What a point of a station has for its height, from a standard normal number and the point's own.
using Height = std::function<double(int station, int point, double normal)>;

bool isInArc(int station) { return station >= 100 && station < 130; }

struct Pad {
  int points = 60, every = 1;  ///< of a station, and of so many
  double shell_noise = kShellNoise;
  int unknown_from = 0, unknown = 0;  ///< stations that do not stand

  FootPass pass() const {
    FootFit fit;
    fit.z = fit.along = fit.bend = fit.slope = 0.0, fit.sigma = 0.0002, fit.noise = 0.003;
    FootPass pass;
    pass.fits.assign(360, fit);
    std::fill_n(pass.fits.begin() + unknown_from, unknown, FootFit{});
    pass.priors.slope.assign(360, 0.0), pass.priors.sigma_slope.assign(360, 0.003);
    pass.priors.sigma_bend = 0.003;
    FootProfile& pad = pass.sections.whole;
    pad.bin = 0.003, pad.band_from = 0.0, pad.band_to = pad.edge = 0.3;
    pad.blur = 0.004, pad.noise = 0.003, pad.surface = Surface::Foundation;
    pass.sections.stations = 360;
    pass.outliers.reasons.assign(360, Unmeasured::None);
    pass.outliers.refused.assign(360, {});
    return pass;
  }

  Foot& foot(MadeFoot& made, const Height& height) const {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    for (int s = 0; s < 360; s += every) {
      int point = 0;
      made.addStation(s, points, 0.01, 0.29, [&](double) { return height(s, point++, normal(random)); });
    }
    return made.foot({0.3, shell_noise, 0.013});
  }

  std::vector<bool> rough(const Height& height) const {
    MadeFoot made;
    const Foot& scanned = foot(made, height);
    return findRoughArcs(scanned, pass(), ownOf(scanned));
  }

  std::vector<FootFit> ownOf(const Foot& scanned) const {
    const FootPass here = pass();
    std::vector<FootFit> own(360);
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (here.fits[i].valid()) own[i] = ownFit(scanned, i, here, kWithNeighbours * scanned.half_step);
    }
    return own;
  }
};

/// Points that scatter so much in an arc.
Height scattering(double in_arc) {
  return [=](int station, int, double normal) { return (isInArc(station) ? in_arc : kUsual) * normal; };
}

std::ptrdiff_t countOf(const std::vector<bool>& found) { return std::count(found.begin(), found.end(), true); }

TEST(FindRoughArcs, AreThoseThatScatterFarMoreThanUsualAndThanNoise) {
  const std::vector<bool> found = Pad{}.rough(scattering(1.3 * kMost));
  for (int i = 0; i < 360; ++i) {
    const bool in = i > 101 && i < 128, out = i < 95 || i > 134;
    EXPECT_TRUE(found[static_cast<std::size_t>(i)] ? !out : !in) << i;
  }
  EXPECT_EQ(countOf(Pad{}.rough(scattering(0.85 * kMost))), 0);
}

TEST(FindRoughArcs, ThriceTheVarianceIsUsual) {
  const Pad still{60, 1, 1e-5};
  EXPECT_EQ(countOf(still.rough(scattering(std::sqrt(2.4) * kUsual))), 0);
  EXPECT_GT(countOf(still.rough(scattering(std::sqrt(4.0) * kUsual))), 20);
}

TEST(FindRoughArcs, NoiseIsUpToThatAboutTheShell) {
  EXPECT_GT(countOf(Pad{60, 1, 0.0014}.rough(scattering(0.002))), 20);
  EXPECT_EQ(countOf(Pad{60, 1, 0.0022}.rough(scattering(0.002))), 0);
}

TEST(FindRoughArcs, FifteenPointsTell) {
  EXPECT_GT(countOf(Pad{8, 3}.rough(scattering(0.004))), 10) << "24 points in 9 degrees";
  EXPECT_EQ(countOf(Pad{13, 9}.rough(scattering(0.008))), 0) << "13";
}

/// Two scans, each as smooth as elsewhere, so far apart in an arc.
Height doubled(double apart, double noise = kUsual) {
  return [=](int station, int point, double normal) {
    return noise * normal + (isInArc(station) && point % 2 == 0 ? apart : 0.0);
  };
}

TEST(FindRoughArcs, TwoScansThatDisagreeAreNone) {
  EXPECT_EQ(countOf(Pad{}.rough(doubled(0.004))), 0);
  EXPECT_EQ(countOf(Pad{900}.rough(doubled(0.004))), 0) << "some of so many points tell";
}

TEST(FindRoughArcs, EightPointsOfAWindowTellTwoLevels) {
  EXPECT_EQ(countOf(Pad{12, 3}.rough(doubled(0.008, 0.0001))), 0);
  EXPECT_GT(countOf(Pad{7, 3}.rough(doubled(0.008, 0.0001))), 10) << "any few points lie about two levels";
}

TEST(FindRoughArcs, TwoLevelsThatAreRoughOrCloseAreRough) {
  const Height rough = [](int station, int point, double normal) {
    return isInArc(station) ? 1.3 * kMost * normal + (point % 2 == 0 ? 0.006 : 0.0) : kUsual * normal;
  };
  EXPECT_GT(countOf(Pad{}.rough(rough)), 20);
  const Height close = [](int station, int point, double normal) {
    return isInArc(station) ? 0.95 * kMost * normal + (point % 2 == 0 ? 0.0025 : 0.0) : kUsual * normal;
  };
  EXPECT_GT(countOf(Pad{}.rough(close)), 20) << "less than four deviations apart";
}

TEST(FindRoughArcs, StationsThatDoNotStandTellNothing) {
  const std::vector<bool> found = Pad{60, 1, kShellNoise, 95, 40}.rough(scattering(0.004));
  EXPECT_EQ(countOf(found), 0);
  MadeFoot none;
  none.add(0.0, 0.1, 0.0);
  EXPECT_EQ(countOf(findRoughArcs(none.foot(), Pad{}.pass(), std::vector<FootFit>(360))), 0);
}

TEST(WithoutRoughArcs, TheirStationsAreOfAnotherSurfaceAndMayBeTheDatumNevertheless) {
  MadeFoot made;
  const Pad pad{60, 1, kShellNoise, 110, 2};
  const Foot& foot = pad.foot(made, scattering(0.004));
  FootPass before = pad.pass();
  before.outliers.own = pad.ownOf(foot);
  const FootPass pass = withoutRoughArcs(foot, std::move(before));
  EXPECT_FALSE(pass.fits[115].valid());
  EXPECT_EQ(pass.outliers.reasons[115], Unmeasured::OtherSurface);
  EXPECT_EQ(pass.outliers.refused[115].z, 0.0);
  EXPECT_EQ(pass.outliers.reasons[110], Unmeasured::None) << "was not measured before";
  EXPECT_TRUE(std::isnan(pass.outliers.refused[110].z));
  EXPECT_TRUE(pass.fits[50].valid());
  EXPECT_EQ(pass.outliers.reasons[50], Unmeasured::None);
}

}  // namespace tank_datum::rough_arcs_test
