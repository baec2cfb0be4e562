#include "foot/soil_fillets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/made_feet.h"

namespace tank_datum::soil_fillets_test {

using namespace made_feet;

constexpr double kFall = 0.05, kEnd = 0.3;  // of a pad, and of what is looked at of it

/// Heights against station and distance from the shell, above the line that stations are fitted by.
using Section = std::function<double(int station, double d)>;

struct Pad {
  bool settled = false;
  int points = 60, every = 1;         ///< of a station, and of so many
  int unknown_from = 0, unknown = 0;  ///< stations that do not stand

  std::vector<bool> fillets(const Section& section) const {
    MadeFoot made;
    for (int i = 0; i < 360; i += every)
      made.addStation(i, points, 0.014, kEnd, [&](double d) { return section(i, d) - kFall * d; });
    FootFit fit;
    fit.z = fit.along = fit.bend = 0.0, fit.slope = -kFall, fit.sigma = 0.0002;
    FootPass pass;
    pass.fits.assign(360, fit);
    std::fill_n(pass.fits.begin() + unknown_from, unknown, FootFit{});
    pass.priors.settled = settled;
    pass.sections.whole.edge = kEnd;
    return findFillets(made.foot(), pass, pass.fits);
  }
};

bool isInArc(int station) { return station >= 100 && station <= 140; }

/// Soil in an arc that is so thick at the shell and ends in so much, upon a pad whose sections bend by so much usually.
Section soil(double thick, double end, double usual = 0.0) {
  return [=](int station, double d) {
    const double bend = usual * (station / 15 % 3 - 1);
    return (d < 0.109 ? bend : 0.0) + (isInArc(station) ? thick * std::max(0.0, 1.0 - d / end) : 0.0);
  };
}

std::ptrdiff_t countOf(const std::vector<bool>& found) { return std::count(found.begin(), found.end(), true); }

TEST(FindFillets, AreSoilThatEndsWithinTheReach) {
  const std::vector<bool> found = Pad{}.fillets(soil(0.012, 0.15));
  EXPECT_TRUE(found[120]);
  for (int i = 0; i < 360; ++i) {
    const bool in = i > 105 && i < 135, out = i < 94 || i > 146;
    EXPECT_TRUE(found[static_cast<std::size_t>(i)] ? !out : !in) << i;
  }
}

TEST(FindFillets, AreNotSlopesNorBarePads) {
  EXPECT_EQ(countOf(Pad{}.fillets(soil(0.0, 0.15))), 0);
  EXPECT_EQ(countOf(Pad{}.fillets(soil(0.012, kEnd))), 0);  // straight to the end
}

TEST(FindFillets, BendUpwards) { EXPECT_EQ(countOf(Pad{}.fillets(soil(-0.012, 0.15))), 0); }

/// A crown so high beyond 205 mm, where the outer part begins, with soil of so much at the shell.
bool isFilletBesideCrown(double crown, double soil) {
  return Pad{}.fillets([=](int station, double d) {
    return isInArc(station) ? (d > 0.205 ? crown : 0.0) + (d < 0.1085 ? soil : 0.0) : 0.0;
  })[120];
}

TEST(FindFillets, AreNotCrownsThatComeNearer) {
  EXPECT_FALSE(isFilletBesideCrown(0.004, 0.0));
  EXPECT_FALSE(isFilletBesideCrown(0.004, 0.002));
  EXPECT_TRUE(isFilletBesideCrown(0.002, 0.004));
  EXPECT_TRUE(isFilletBesideCrown(0.0, 0.004));
}

/// The first part ends at 109 mm: steps there are bends.
TEST(FindFillets, BendByAHundredthOfAPartsWidth) {
  const auto stepped = [](double step) -> bool {
    return Pad{}.fillets([=](int station, double d) { return isInArc(station) && d < 0.1085 ? step : 0.0; })[120];
  };
  EXPECT_FALSE(stepped(0.0008));  // of 96 mm
  EXPECT_TRUE(stepped(0.0012));
}

TEST(FindFillets, BendByThreeTimesWhatArcsUsuallyDo) {
  const auto stepped = [](double step) -> bool {
    return Pad{}.fillets([=](int station, double d) {
      const double usual = 0.001 * (station / 15 % 3 - 1);  // a standard deviation of 1.5 mm, by the middle of all
      return d < 0.1085 ? (isInArc(station) ? step : usual) : 0.0;
    })[120];
  };
  EXPECT_FALSE(stepped(0.0045));
  EXPECT_TRUE(stepped(0.0065));
}

TEST(FindFillets, GoOnAsFarAsTheyBendMoreThanUsual) {
  const auto found = Pad{}.fillets([](int station, double d) {
    const double usual = 0.001 * (station / 15 % 3 - 1);
    const double step = isInArc(station) ? (station < 120 ? 0.0035 : 0.0070) : usual;
    return d < 0.1085 ? step : 0.0;
  });
  EXPECT_TRUE(found[110] && found[130]);
  EXPECT_FALSE(found[80]);
}

TEST(FindFillets, AreNotOfLips) { EXPECT_EQ(countOf(Pad{true}.fillets(soil(0.012, 0.15))), 0); }

TEST(FindFillets, TenPointsOfEachPartTell) {
  const auto found = [](int every) -> bool { return Pad{false, 3, every}.fillets(soil(0.012, 0.15))[120]; };
  EXPECT_TRUE(found(1));   // eleven
  EXPECT_FALSE(found(2));  // five or six
}

/// Of stations from the 100th on in the first part, against a level pad.
std::vector<bool> stepped(const Pad& pad, int stations, double step, int weak = 0, double weak_step = 0.0) {
  return pad.fillets([=](int station, double d) {
    if (d > 0.1085) return station % 2 == 0 ? 0.0002 : -0.0002;
    const bool in = station >= 100 && station < 100 + stations, after = !in && station >= 100 && station < 100 + weak;
    return in ? step : after ? weak_step : 0.001 * (station / 15 % 3 - 1);
  });
}

TEST(FindFillets, FiveDegreesToEitherSideTellTogether) {
  EXPECT_TRUE(stepped({}, 7, 0.02)[103]);
  EXPECT_FALSE(stepped({}, 4, 0.02)[102]);
}

TEST(FindFillets, ATenthOfTheReachIsTheHighest) {
  EXPECT_TRUE(stepped({}, 30, 0.045)[115]);
  EXPECT_FALSE(stepped({}, 30, 0.055)[115]);
}

TEST(FindFillets, GoOnOverTwoDegrees) {
  const auto goes_on = [](int missing) -> bool {
    return stepped(Pad{false, 60, 1, 120, missing}, 20, 0.008, 60, 0.0035)[140];
  };
  EXPECT_TRUE(goes_on(2));
  EXPECT_FALSE(goes_on(3));
}

}  // namespace tank_datum::soil_fillets_test
