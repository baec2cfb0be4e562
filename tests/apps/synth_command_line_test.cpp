#include <gtest/gtest.h>

#include <filesystem>

#include "core/units.h"
#include "synth/command_line.h"
#include "tank_datum/core/error.h"

namespace tank_datum::synth::synth_command_line_test {

bool parse(std::vector<std::string> words, Command& command, int& status) {
  words.insert(words.begin(), "tank_datum_synth");
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  return parseCommandLine(static_cast<int>(argv.size()), argv.data(), command, status);
}

TEST(SynthCommandLine, OptionsGoOverTheSceneFile) {
  const auto scene = std::filesystem::path(TANK_DATUM_TEST_SCENES) / "plate60.json";
  Command command;
  int status = 0;
  ASSERT_TRUE(parse({"-o", "a/b.pcd", "--scene", scene.string(), "--radius", "12.5", "--harmonics",
                     "2:0.003:45,3:0.002:10", "--dips", "10:20:0.01", "--offset", "1,2,3.5", "--mixed-pixels",
                     "--foundation", "crown", "--set", "tanks/0/roof_rise=2.5"},
                    command, status));
  const TankOptions& tank = command.scene.tanks[0];
  EXPECT_EQ(command.truth, "a/b.truth.json");
  EXPECT_EQ(tank.radius, 12.5);
  EXPECT_EQ(tank.height, 15.0);
  ASSERT_EQ(tank.harmonics.size(), 2u);
  EXPECT_EQ(tank.harmonics[1].n, 3);
  EXPECT_NEAR(tank.harmonics[0].phase, kPi / 4.0, 1e-12);
  EXPECT_EQ(tank.dips[0].depth, 0.01);
  EXPECT_EQ(tank.foundation.kind, "crown");
  EXPECT_EQ(tank.roof_rise, 2.5);
  EXPECT_EQ(command.scene.offset[2], 3.5);
  EXPECT_TRUE(command.scene.measurement.mixed_pixels);
}

TEST(SynthCommandLine, NumbersAreReadAsPeopleTypeThem) {
  Command command;
  int status = 0;
  ASSERT_TRUE(parse({"-o", "a.pcd", "--radius", "12.", "--tilt-slope", ".002", "--scanners", "3"}, command, status));
  EXPECT_EQ(command.scene.tanks[0].radius, 12.0);
  EXPECT_EQ(command.scene.tanks[0].tilt_slope, 0.002);
  for (const char* no_number : {"", "12 m", "inf", "0x10", "1e999"})
    EXPECT_THROW(parse({"-o", "a.pcd", "--radius", no_number}, command, status), Error) << no_number;
}

TEST(SynthCommandLine, WrongUseIsRefused) {
  Command command;
  int status = 0;
  EXPECT_FALSE(parse({"--radius", "3"}, command, status));
  EXPECT_EQ(status, 2);
  EXPECT_FALSE(parse({"-o", "a.pcd", "--no-such-option"}, command, status));
  EXPECT_THROW(parse({"-o", "a.pcd", "--radius", "wide"}, command, status), Error);
  EXPECT_THROW(parse({"-o", "a.pcd", "--harmonics", "2:0.003"}, command, status), Error);
  EXPECT_THROW(parse({"-o", "a.pcd", "--offset", "1,2"}, command, status), Error);
  EXPECT_THROW(parse({"-o", "a.pcd", "--set", "tanks/0/nothing=1"}, command, status), Error);
}

}  // namespace tank_datum::synth::synth_command_line_test
