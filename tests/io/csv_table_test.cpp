#include "io/csv_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/pcd_files.h"
#include "support/refused.h"
#include "tank_datum/core/error.h"

namespace tank_datum::csv_table_test {

using pcd_files::Folder;

TEST(CsvTable, IsReadByTheNamesOfItsColumns) {
  const Folder folder;
  const CsvTable table(folder.file("a.csv", "b,a,reason\r\n2,1,hidden\r\n,-3.5e-3,\r\n7\r\n"), "stations");
  ASSERT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.number(0, "a"), 1.0);
  EXPECT_EQ(table.number(0, "b"), 2.0);
  EXPECT_EQ(table.text(0, "reason"), "hidden");
  EXPECT_EQ(table.number(1, "a"), -3.5e-3);
  EXPECT_TRUE(std::isnan(table.number(1, "b")));
  EXPECT_EQ(table.number(2, "b"), 7.0);
  EXPECT_TRUE(std::isnan(table.number(2, "a")));
}

TEST(CsvTable, NamesWhatIsWrong) {
  const Folder folder;
  const std::string path = folder.file("a.csv", "a,b\n1,x\ninf,2\n");
  const CsvTable table(path, "stations");
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { table.number(0, "b"); }),
            "stations: b in " + path + " line 2, x, expected a number");
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { table.number(1, "a"); }),
            "stations: a in " + path + " line 3, inf, expected a number");
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { table.number(0, "c"); }),
            "stations: header of " + path + ", no c, expected a column of that name");
  EXPECT_NE(refusalOf(Error::Kind::File, [&] { CsvTable(folder.path("none.csv"), "stations"); }).find("none.csv"),
            std::string::npos);
  EXPECT_NE(refusalOf(Error::Kind::File, [&] { CsvTable(folder.file("e.csv", ""), "stations"); }).find("empty"),
            std::string::npos);
  const std::string commas = folder.file("c.csv", "a,b\n1\n1,5,2,5\n");
  EXPECT_EQ(refusalOf(Error::Kind::File, [&] { CsvTable(commas, "stations"); }),
            "stations: " + commas + " line 3, 4 cells, expected 2 as in the header line, numbers with decimal points");
}

}  // namespace tank_datum::csv_table_test
