#include "core/cell_number.h"

#include <gtest/gtest.h>

namespace tank_datum::cell_number_test {

TEST(CellNumber, IsTheWholeNumberBelow) {
  EXPECT_EQ(cellNumber(0.0), 0);
  EXPECT_EQ(cellNumber(2.999), 2);
  EXPECT_EQ(cellNumber(-0.001), -1);
  EXPECT_EQ(cellNumber(-3.0), -3);
}

TEST(CellNumber, OfWhatLiesBeyondIsTheLast) {
  const std::int64_t last = std::int64_t{1} << 62;
  EXPECT_EQ(cellNumber(1e300), last);
  EXPECT_EQ(cellNumber(-1e300), -last);
  EXPECT_EQ(cellNumber(static_cast<double>(last / 2)), last / 2);
}

}  // namespace tank_datum::cell_number_test
