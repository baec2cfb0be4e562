#include <gtest/gtest.h>

#include "setups/agreement.h"
#include "support/test_folder.h"
#include "tank_datum/core/error.h"

namespace tank_datum::setup_origins_test {

std::map<std::string, Eigen::Vector3d> read(const std::string& text, double metres = 1.0) {
  const TestFolder folder;
  return readSetupOrigins(folder.file("setup_origins.csv", text), metres);
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(SetupOrigins, AreReadByName) {
  const auto origins = read("name,x,y,z\nscan_1,10,20,1.5\n7,-1,2e1,0\n", 0.001);
  ASSERT_EQ(origins.size(), 2U);
  EXPECT_EQ(origins.at("scan_1"), Eigen::Vector3d(0.010, 0.020, 0.0015));
  EXPECT_EQ(origins.at("7"), Eigen::Vector3d(-0.001, 0.020, 0.0));
}

TEST(SetupOrigins, BadRowsAreRefusedByLine) {
  EXPECT_NE(refusal("a,1,2\n").find("line 1"), std::string::npos);
  EXPECT_NE(refusal("a,1,2,3\nb,1,two,3\n").find("line 2, \"two\""), std::string::npos);
  EXPECT_NE(refusal("a,1,2,3\na,1,2,3\n").find("\"a\" again"), std::string::npos);
  EXPECT_NE(refusal("a,1,2,nan\n").find("coordinate"), std::string::npos);
  EXPECT_THROW(readSetupOrigins("/no/such/file.csv"), Error);
}

}  // namespace tank_datum::setup_origins_test
