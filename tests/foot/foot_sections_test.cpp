#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "core/portable_math.h"
#include "support/made_feet.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::foot_sections_test {

using namespace made_feet;

double ringwall(double d) { return d < 0.2 ? 0.0 : -0.25; }
double plate(double d) { return d < 0.065 ? 0.0 : -0.010; }

/// Sections of a foot; stations 100 to 160 differ from the others.
class Sections {
 public:
  using Section = std::function<double(double)>;

  Sections(const Section& usual, const Section& other, int points, double other_noise = 0.0005, int other_points = 0) {
    for (int s = 0; s < 360; ++s) {
      const bool differs = s >= 100 && s <= 160;
      const double noise = differs ? other_noise : 0.0005;
      const Section& section = differs ? other : usual;
      made_.addStation(s, differs && other_points > 0 ? other_points : points, 0.005, 0.3,
                       [&](double d) { return section(d) + noise * normal_(random_); });
    }
    found = stackSections(made_.foot(), std::vector<double>(360, 0.0));
  }

  const FootProfile& there() const { return found.at(130); }

  FootSections found;

 private:
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_;
  MadeFoot made_;
};

TEST(StackSections, WhereTheSurfaceEndsThereIsASectionEveryFiveDegrees) {
  EXPECT_EQ(360U / Sections(ringwall, ringwall, 60).found.arcs.size(), 5U);
}

TEST(StackSections, AnArcNeedsThreeThousandPointsWithinThirtyDegreesOnEitherSide) {
  for (const int points : {45, 54}) {  // of each of 61 stations
    const Sections sections(ringwall, ringwall, points);
    EXPECT_EQ(sections.there().bin > sections.found.whole.bin, points > 50) << points;
  }
}

TEST(StackSections, AnArcAtAnotherLevelIsAnotherSurfaceFromAHundredAndTwentyFifthOfTheSection) {
  const auto offset = [](double raised) {
    return Sections(
               ringwall, [=](double d) { return ringwall(d) + raised; }, 100)
        .there()
        .offset;
  };
  EXPECT_NEAR(offset(0.0016), 0.0016, 0.0003);
  EXPECT_LT(offset(0.0028), 0.0008);
}

TEST(StackSections, AnArcMoreThanTwoAndAHalfTimesAsRoughIsAnotherSurface) {
  const auto roughness = [](double noise) { return Sections(ringwall, ringwall, 100, noise).there().noise; };
  EXPECT_NEAR(roughness(0.0010), 0.0010, 0.0001);
  EXPECT_LT(roughness(0.0018), 0.0008);
}

TEST(StackSections, ALipMayLeanByEightHundredthsMoreThanTheRings) {
  const auto slope = [](double s) {
    return Sections(
               plate, [=](double d) { return plate(d) + s * d; }, 100)
        .there()
        .slope;
  };
  EXPECT_NEAR(slope(-0.065), -0.065, 0.01);
  EXPECT_GT(slope(-0.092), -0.02);
}

TEST(StackSections, AnArcOnWhichALipGoesOnHalfAsFarAgainShowsWhatLiesBeyondIt) {
  const auto band_to = [](double edge) {
    return Sections(
               plate, [=](double d) { return d < edge ? 0.0 : -0.010; }, 100)
        .there()
        .band_to;
  };
  EXPECT_GT(band_to(0.090), 0.072);
  EXPECT_LT(band_to(0.110), 0.070);
  EXPECT_LT(band_to(0.290), 0.070);
}

TEST(StackSections, AnArcWhoseLipEndsWhereTheRingsBeginsToBePlainGoesByItsOwn) {
  const auto blended = [](double d) { return d < 0.105 ? 0.5 * square(std::max(0.0, 0.085 - d)) : -0.010; };
  const Sections sections(
      blended, [](double d) { return d < 0.052 ? 0.0 : -0.010; }, 400);
  ASSERT_GT(sections.found.whole.band_from, 0.050);
  EXPECT_NEAR(sections.there().edge, 0.052, 0.004);
  EXPECT_LT(sections.there().band_to, 0.053);
  EXPECT_NEAR(sections.there().offset, 0.0, 0.0005);
}

/// How high the section of an arc says that the lip lies, which is half a millimetre, where rows show it between two
/// distances and beside the shell only, and what lies beyond it from another one on.
double levelOfRows(double from, double to, double beyond) {
  MadeFoot made;
  const auto raised = [](double d) { return plate(d) + 0.0005; };
  for (int s = 0; s < 360; ++s) {
    const bool rows = s >= 100 && s <= 160;
    made.addStation(s, rows ? 0 : 400, 0.005, 0.3, plate);
    made.addStation(s, rows ? 20 : 0, 0.014, 0.019, raised);
    made.addStation(s, rows ? 60 : 0, from, to, [](double) { return 0.0005; });
    made.addStation(s, rows ? 60 : 0, beyond, 0.3, raised);
    made.addStation(s, 600, -0.001, 0.001, [](double) { return 0.1; });  // the shell
  }
  return stackSections(made.foot(), std::vector<double>(360, 0.0)).at(130).offset;
}

TEST(StackSections, AnArcThatShowsLessThanThreeQuartersOfItsBandIsToShowWhereItEnds) {
  EXPECT_NEAR(levelOfRows(0.027, 0.080, 0.12), 0.0005, 0.0001);
  EXPECT_NEAR(levelOfRows(0.050, 0.080, 0.12), 0.0, 0.0002);
  EXPECT_NEAR(levelOfRows(0.050, 0.080, 0.085), 0.0005, 0.0001);
}

TEST(StackSections, OfAnArcWithFortyThousandPointsEverySecondIsTaken) {
  const FootProfile there = Sections(ringwall, ringwall, 60, 0.0005, 3800).there();
  // 11 stations of 3800 points over 295 mm, in bins of 3 mm
  const double per_bin = 11.0 * 3800.0 / 2.0 * 0.003 / 0.295;
  EXPECT_NEAR(there.error[20], 1.2533 * 0.0005 / std::sqrt(per_bin), 0.2 * there.error[20]);
}

TEST(StackSections, ASectionAHundredthOfTheReachOffItsElevationsIsOfAnotherSurface) {
  const auto is_of_level = [](double off) {
    FootProfile section;
    section.band_to = 0.3, section.offset = off;
    return isOfLevel(section, 0.5);
  };
  EXPECT_TRUE(is_of_level(0.0045) && is_of_level(-0.0045));
  EXPECT_FALSE(is_of_level(0.0055) || is_of_level(-0.0055));
  EXPECT_FALSE(isOfLevel({}, 0.5)) << "shows none";
}

/// Sections whose surface lies so far off the elevations they were stacked with.
FootSections sectionsOff(double offset) {
  FootSections sections;
  sections.whole.band_from = 0.02, sections.whole.band_to = 0.1;
  sections.whole.offset = offset;
  return sections;
}

TEST(HeldTo, ASectionOfAnotherLevelIsNotFollowedAndIsTold) {
  const FootSections before = sectionsOff(0.001);
  EXPECT_EQ(heldTo(before, sectionsOff(-0.004), 0.5).whole.offset, -0.004);
  EXPECT_EQ(heldTo(before, sectionsOff(-0.004), 0.5).other_level, 0.0);
  EXPECT_EQ(heldTo(before, sectionsOff(-0.012), 0.5).whole.offset, 0.001);
  EXPECT_EQ(heldTo(before, sectionsOff(-0.012), 0.5).other_level, 0.012);
  FootSections lip = before;
  lip.whole.surface = Surface::AnnularPlate;
  EXPECT_EQ(heldTo(lip, sectionsOff(-0.012), 0.5).other_level, 0.0) << "what it lies on";
  EXPECT_EQ(heldTo(lip, sectionsOff(0.012), 0.5).other_level, 0.012);
  EXPECT_EQ(heldTo({}, sectionsOff(-0.012), 0.5).whole.offset, -0.012) << "there is none before";
  EXPECT_EQ(heldTo(before, {}, 0.5).whole.offset, 0.001);
  EXPECT_EQ(heldTo(before, {}, 0.5).other_level, 0.0) << "shows none";
}

/// The noise of a section of which five stations stand, with so many points each; 355 others are rougher.
double noiseOfFive(int points) {
  MadeFoot made;
  std::vector<double> known(360, kUnknown);
  std::normal_distribution<double> normal;
  std::mt19937_64 random(7);
  for (int s = 0; s < 360; ++s) {
    const bool stands = s < 5;
    if (stands) known[static_cast<std::size_t>(s)] = 0.0;
    made.addStation(s, stands ? points : 100, 0.005, 0.3,
                    [&](double) { return (stands ? 0.0005 : 0.002) * normal(random); });
  }
  return stackKnown(made.foot(), known, std::vector<double>(360, 0.0)).whole.noise;
}

TEST(StackKnown, OfThoseThatStandUnlessTheyAreTooFewToShowASurface) {
  EXPECT_LT(noiseOfFive(600), 0.001);
  EXPECT_GT(noiseOfFive(4), 0.0015);
}

TEST(StackKnown, BeforeAnyAreFittedThereIsNoOtherSection) {
  MadeFoot made;
  made.addStation(0, 3, 0.005, 0.3, [](double) { return 0.0; });
  EXPECT_FALSE(stackKnown(made.foot(), std::vector<double>(360, 0.0), {}).whole.valid());
}

}  // namespace tank_datum::foot_sections_test
