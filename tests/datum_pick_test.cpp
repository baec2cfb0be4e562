// Which of the tanks found a datum is of, and what is said where there is none.

#include <gtest/gtest.h>

#include "support/made_clouds.h"
#include "tank_datum/datum.h"

namespace tank_datum {
namespace {

using namespace made_clouds;

TEST(ExtractDatum, SmallestRadiusDecidesWhetherThereIsATank) {
  DatumOptions options;
  options.locate.min_radius = 6.0;
  EXPECT_EQ(extractDatum(Scan::fromPoints(tankPoints()), options).status, Status::NoTank);
}

TEST(ExtractDatum, OfATankThatIsNotThereKeepsOriginAndCounts) {
  DatumOptions options;
  options.pick = 5;
  const Scan scan = Scan::fromPoints(tankPoints({1000, 2000, 50}));
  std::size_t found = 0;
  const Datum datum =
      extractDatum(scan, options, {{}, [&](const std::vector<Tank>& tanks) { found = tanks.size(); }, {}});
  EXPECT_EQ(found, 1U);
  EXPECT_EQ(datum.status, Status::NoTank);
  EXPECT_EQ(datum.message, "only 1 found, no tank 5 to pick");
  EXPECT_EQ(datum.origin, scan.origin());
  EXPECT_EQ(datum.counts.points, scan.size());
}

TEST(ExtractDatum, OfNoTankIsThatOfAScanWithoutOne) {
  const Scan scan = Scan::fromPoints(floorPoints(50'000, 8.0));
  ASSERT_TRUE(findTanks(scan, {}).empty());
  const Datum datum = extractDatum(Tank(), scan, {}), whole = extractDatum(scan, {});
  EXPECT_EQ(datum.status, Status::NoTank);
  EXPECT_EQ(datum.message, whole.message);
  EXPECT_EQ(datum.counts.points, scan.size());
}

}  // namespace
}  // namespace tank_datum
