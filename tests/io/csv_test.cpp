#include "io/csv.h"

#include <gtest/gtest.h>

#include "tank_datum/core/error.h"

namespace tank_datum::csv_test {

using Cells = std::vector<std::string>;

TEST(CsvRows, CellsAndLines) {
  const auto rows = csvRows("a,b\n\n# note, more\n 1 ,\t2\r\n3,\n");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].cells, (Cells{"a", "b"}));
  EXPECT_EQ(rows[1].cells, (Cells{"1", "2"}));
  EXPECT_EQ(rows[1].line, 4U);
  EXPECT_EQ(rows[2].cells, (Cells{"3", ""}));
}

TEST(CsvRows, Quotes) {
  const auto rows = csvRows("\"a,b\",\"say \"\"x\"\"\"\n\"two\nlines\",z\nlast,row");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].cells, (Cells{"a,b", "say \"x\""}));
  EXPECT_EQ(rows[1].cells, (Cells{"two\nlines", "z"}));
  EXPECT_EQ(rows[2].cells, (Cells{"last", "row"}));
  EXPECT_EQ(rows[2].line, 4U);
}

TEST(CsvRows, MarksAndOddEnds) {
  EXPECT_EQ(csvRows("\xef\xbb\xbfx,y\r1,2\r").size(), 2U);
  EXPECT_EQ(csvRows("\xef\xbb\xbfx,y\n")[0].cells[0], "x");
  EXPECT_TRUE(csvRows("").empty());
  EXPECT_TRUE(csvRows("\n\n").empty());
  EXPECT_EQ(csvRows("a;b\n", ';')[0].cells, (Cells{"a", "b"}));
  EXPECT_EQ(csvRows("\"open,\n").size(), 1U);  // a quote that never ends takes the rest
}

}  // namespace tank_datum::csv_test
