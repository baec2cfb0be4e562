#include "foot/foot_bends.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_bends_test {

using namespace made_feet;

/// A level at every second station; the process lies at 0, both are known to 1 mm together, and it is alike along 20
/// stations.
struct Levels {
  std::vector<double> levels = std::vector<double>(360, kUnknown), sigmas = std::vector<double>(360, kUnknown);
  double strayed = 0.0;  ///< what the process does not follow lies so far off [m]

  Levels() {
    for (std::size_t i = 0; i < 360; i += 2) levels[i] = 0.0, sigmas[i] = 0.0006;
  }
  std::vector<Bend> bends() const {
    MadeFoot made;
    RingProcess process;
    process.value.assign(360, 0.0), process.sigma.assign(360, std::hypot(0.0008, kEither * strayed));
    process.strayed.assign(360, strayed);
    process.amplitude = 0.01, process.length = toRadians(20.0), process.nugget = 0.0;
    return findBends(made.foot(), levels, sigmas, process);
  }
};

std::ptrdiff_t likely(const std::vector<Bend>& bends) { return std::count(bends.begin(), bends.end(), Bend::Likely); }

TEST(FindBends, NeighboursOffToOneSideAreABendAsFarAsTheProcessIsAlike) {
  Levels two;
  two.levels[100] = two.levels[102] = 0.003;
  EXPECT_EQ(likely(two.bends()), 43);  // 80 to 122
  two.levels[102] = -0.003;
  EXPECT_EQ(likely(two.bends()), 0);
}

TEST(RisesOfARing, AreHalvedAndDoubtedDipsAreNot) {
  RingProcess process;
  process.value = {0.010, -0.010, 0.0};
  process.sigma = {0.001, 0.001, 0.001};
  process.bent = {0.010, -0.010, 0.0};
  const RingProcess doubted = withRisesDoubted(process);
  EXPECT_DOUBLE_EQ(doubted.value[0], 0.005);
  EXPECT_DOUBLE_EQ(doubted.sigma[0], std::hypot(0.001, kEither * 0.010));
  EXPECT_DOUBLE_EQ(doubted.value[1], -0.010);
  EXPECT_DOUBLE_EQ(doubted.sigma[1], 0.001);
  EXPECT_DOUBLE_EQ(doubted.value[2], 0.0);
}

/// The constants, at some 10 % on either side of them.
TEST(FindBends, OneIsFarOffAndItsNeighbourHalfAsFar) {
  const auto found = [](double one, double other) {
    Levels two;
    two.levels[100] = one, two.levels[102] = other;
    return likely(two.bends()) > 0;
  };
  EXPECT_TRUE(found(0.0027, 0.0017));
  EXPECT_FALSE(found(0.0023, 0.0017));
  EXPECT_FALSE(found(0.0027, 0.0013));
}

TEST(FindBends, ALevelThatLiesFarOffAloneIsDoubtedUpToItsNeighbours) {
  const auto found = [](double height, std::size_t at) {
    Levels one;
    one.levels[at] = height;
    return one.bends();
  };
  EXPECT_EQ(likely(found(0.0037, 100)), 0);
  for (const std::size_t at : {std::size_t{0}, std::size_t{100}, std::size_t{358}}) {
    const std::vector<Bend> bends = found(0.0044, at);
    EXPECT_EQ(likely(bends), 3) << at;
    EXPECT_EQ(bends[(at + 359) % 360], Bend::Likely) << at;
    EXPECT_EQ(bends[(at + 1) % 360], Bend::Likely) << at;
  }
}

/// What a level that the process does not follow adds to its sigma is no reason to leave that level out.
TEST(FindBends, ALevelThatTheProcessDoesNotFollowIsJudgedByTheSigmaOfThoseItFollows) {
  Levels one;
  one.levels[100] = one.strayed = 0.0044;
  EXPECT_EQ(likely(one.bends()), 3);
}

/// Two standard errors hold the own level and the process.
TEST(BentFit, StandsOnItsOwnWindowWithASigmaThatHoldsBoth) {
  RingProcess process;
  process.value.assign(360, 0.0), process.sigma.assign(360, 0.0002);
  FootFit own;
  own.z = 0.005, own.sigma = 0.0003;
  const FootFit likely = bentFit(own, process, 7, 0.0004, Bend::Likely),
                seen = bentFit(own, process, 7, 0.0004, Bend::Seen);
  EXPECT_EQ(likely.z, 0.005);
  EXPECT_NEAR(likely.sigma, std::hypot(0.0005, 0.0015), 1e-6);
  EXPECT_NEAR(seen.sigma, 0.0005, 1e-6);
}

TEST(Disagreement, OfAWindowThreeStandardErrorsOffTheProcessIsAsOfTheOneOrTheOther) {
  RingProcess process;
  process.value = {0.0}, process.sigma = {0.0008};
  FootFit window;
  window.sigma = 0.0006;
  for (const double side : {-1.0, 1.0}) {
    window.z = side * 0.0029;
    EXPECT_EQ(disagreement(window, process, 0), 0.0);
    window.z = side * 0.0031;
    EXPECT_NEAR(disagreement(window, process, 0), kEither * 0.0031, 1e-12);
  }
}

}  // namespace tank_datum::foot_bends_test
