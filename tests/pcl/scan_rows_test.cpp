#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "tank_datum/pcl/pcl_stages.h"

namespace tank_datum::scan_rows_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Points allOf(const Scan& scan) {
  Points points;
  scan.forEachBlock([&](const Points& block) { points.insert(points.end(), block.begin(), block.end()); });
  return points;
}

TEST(RowsOf, AreThePlacesAmongTheFinitePoints) {
  const Scan scan = Scan::fromPoints({{kNaN, 0, 0}, {4e6, 0.1, 0}, {4e6, 0.2, 0}, {1, kNaN, 0}, {4e6, 0.3, 1e-9}});
  const Points points = allOf(scan);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(rowsOf({points[2], points[0]}, scan), (std::vector<std::size_t>{2, 0}));
  EXPECT_EQ(rowsOf({}, scan), std::vector<std::size_t>());
}

TEST(RowsOf, PointsInOnePlaceGetARowEach) {
  const Scan scan = Scan::fromPoints({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  std::vector<std::size_t> rows = rowsOf({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, scan);
  EXPECT_EQ(rows[2], 1U);
  std::sort(rows.begin(), rows.end());
  EXPECT_EQ(rows, (std::vector<std::size_t>{0, 1, 2}));
}

TEST(RowsOf, APointOfNoScanIsAnError) {
  EXPECT_THROW(rowsOf({{0.5, 0, 0}}, Scan::fromPoints({{1, 0, 0}})), std::logic_error);
}

}  // namespace tank_datum::scan_rows_test
