#include "foot/mixed_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/units.h"
#include "foot/refine.h"
#include "support/made_rings.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum::mixed_levels_test {

constexpr double kRadius = 5.0, kArc = kRadius * kDegree, kReach = 0.5;

/// A section whose lip ends so far out, and what lies beyond it so much lower.
FootProfile lip(double edge, double drop) {
  FootProfile section;
  section.bin = 0.003;
  section.blur = 0.004;
  section.surface = Surface::AnnularPlate;
  section.edge = edge;
  section.band_from = 0.015;
  section.band_to = edge;
  for (int i = 0; i < 100; ++i) section.height.push_back((i + 0.5) * section.bin < edge ? 0.0 : -drop);
  return section;
}

/// Stations at `high` on the first ones, at 0 on the others, all of them off by what neighbours differ by.
std::vector<double> twoLevels(std::size_t first, double high, double off = 0.0003) {
  std::vector<double> levels;
  for (std::size_t i = 0; i < 360; ++i) levels.push_back((i < first ? high : 0.0) + (i % 2 == 0 ? off : -off));
  return levels;
}

/// How many of the first stations and of the others are kept.
std::pair<int, int> keptOf(const OneLevel& one, std::size_t first) {
  const std::vector<double>& levels = one.known;
  if (levels.empty()) return {-1, -1};
  const auto known = [](double z) { return std::isfinite(z); };
  const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(first);
  return {static_cast<int>(std::count_if(levels.begin(), middle, known)),
          static_cast<int>(std::count_if(middle, levels.end(), known))};
}

TEST(OfOneLevel, TheLevelOfMostIsKept) {
  const FootProfile plate = lip(0.066, 0.020);
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(100, 0.020), plate, kArc, kReach), 100), std::pair(0, 260));
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(260, 0.020), plate, kArc, kReach), 260), std::pair(260, 0));
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(100, -0.020), plate, kArc, kReach), 100), std::pair(0, 260));
}

TEST(OfOneLevel, OfWhatMayBeACableTheLowerIsKept) {
  const FootProfile cable = lip(0.027, 0.030);
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(100, 0.030), cable, kArc, kReach), 100), std::pair(0, 260));
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(260, 0.030), cable, kArc, kReach), 260), std::pair(0, 100));
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(260, 0.016), cable, kArc, kReach), 260), std::pair(0, 100));
  EXPECT_EQ(keptOf(ofOneLevel(twoLevels(260, 0.014), cable, kArc, kReach), 260), std::pair(260, 0))
      << "less than half as high: another step";
  EXPECT_NEAR(ofOneLevel(twoLevels(260, 0.030), cable, kArc, kReach).below_most, 0.030, 1e-9);
  EXPECT_EQ(ofOneLevel(twoLevels(100, 0.030), cable, kArc, kReach).below_most, 0.0);
}

TEST(OfOneLevel, WhereNothingStepsThereIsOneLevel) {
  const FootProfile cable = lip(0.027, 0.030);
  EXPECT_TRUE(ofOneLevel(twoLevels(100, 0.0), cable, kArc, kReach).known.empty());
  EXPECT_TRUE(ofOneLevel(twoLevels(100, 0.003), cable, kArc, kReach).known.empty()) << "as a datum may do in a degree";
  EXPECT_TRUE(ofOneLevel(twoLevels(100, 0.020, 0.004), cable, kArc, kReach).known.empty()) << "as neighbours do";
  EXPECT_TRUE(ofOneLevel(std::vector<double>(360, kUnknown), cable, kArc, kReach).known.empty());
}

TEST(GoesOnFarther, ByMoreThanAnEdgeIsBlurred) {
  const FootProfile narrow = lip(0.027, 0.030);
  EXPECT_TRUE(goesOnFarther(lip(0.0315, 0.0), narrow));
  EXPECT_FALSE(goesOnFarther(lip(0.0305, 0.0), narrow));
  EXPECT_FALSE(goesOnFarther({}, narrow));
}

double level(double) { return 0.0; }

/// The stations that are measured of a shell upon a pad, with a square duct beside it over so much of the
/// circumference.
std::vector<StationDatum> measuredBesideDuct(double share, double thick) {
  constexpr double kNoise = 0.0005;
  made_rings::MadeRing<level> made(5);
  for (int i = 0; i < 150'000; ++i) made.add(kRadius + made.noise(0.001), 0.5 * made.any());
  for (int i = 0; i < 150'000; ++i) made.add(kRadius + 0.4 * made.any(), made.noise(kNoise));
  for (Eigen::Vector3d& p : made.ring.points) {
    const double azimuth = std::atan2(p.y(), p.x()) + 0.5 * kTwoPi, d = std::hypot(p.x(), p.y()) - kRadius;
    if (azimuth > share * kTwoPi) continue;
    const bool shell = d < 0.004, behind = p.z() < thick;
    if (shell && behind) p.z() += thick;  // hidden: seen higher up
    if (!shell && d > 0.0 && d < thick) p.z() += thick;
  }
  return made_rings::measuredOf(refineStations(made.ring, made_rings::levelTank(kRadius), {}, {}).stations);
}

TEST(RefineStations, ADuctInTheCornerOfAnArcHidesThatArcAloneAndMayBeAPlateOfMost) {
  for (const double share : {0.2, 0.3, 0.6, 0.7}) {
    const std::vector<StationDatum> measured = measuredBesideDuct(share, 0.030);
    EXPECT_GE(static_cast<double>(measured.size()), 360.0 * (1.0 - share) - 4.0) << share;
    EXPECT_LE(static_cast<double>(measured.size()), 360.0 * (1.0 - share) + 24.0) << share << ": the pad beyond it";
    for (const StationDatum& s : measured) {
      EXPECT_NEAR(s.z, 0.0, 0.001) << share << " " << s.direction;
      EXPECT_EQ(s.sigma_z > 0.014, share > 0.5) << share << ": most may stand on a plate that others lack";
    }
  }
}

}  // namespace tank_datum::mixed_levels_test
