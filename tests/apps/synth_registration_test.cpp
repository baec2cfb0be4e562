#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/synth_scenes.h"
#include "support/test_folder.h"
#include "synth/output.h"

/// Scanners whose points are brought into the common frame with an error.
namespace tank_datum::synth::synth_registration_test {

SceneOptions scenesWith(const RegistrationError& error) {
  SceneOptions scene = plainScene();
  scene.scanner.registration.errors = {error};
  return scene;
}

TEST(SynthRegistration, ShiftMovesEveryPointByTheSame) {
  RegistrationError error;
  error.dx = 0.003, error.dy = -0.002, error.dz = 0.005;
  const Rows right = rowsOf(plainScene()), shifted = rowsOf(scenesWith(error));
  ASSERT_EQ(right.size(), shifted.size());
  for (std::size_t i = 0; i < right.size() / 4; i += 97) {
    EXPECT_NEAR((pointOf(shifted, i) - pointOf(right, i) - Eigen::Vector3d(0.003, -0.002, 0.005)).norm(), 0.0, 1e-12);
  }
}

TEST(SynthRegistration, TiltIsTheSlopeOfZAboutTheScannerAndKeepsDistances) {
  RegistrationError error;
  error.tilt_x = 1e-4, error.tilt_y = -2e-4;
  const SceneOptions scene = scenesWith(error);
  const Eigen::Vector3d scanner = scanStations(Scene(scene))[0].position;
  const Rows right = rowsOf(plainScene()), tilted = rowsOf(scene);
  ASSERT_EQ(right.size(), tilted.size());
  for (std::size_t i = 0; i < right.size() / 4; i += 97) {
    const Eigen::Vector3d arm = pointOf(right, i) - scanner, turned = pointOf(tilted, i) - scanner;
    EXPECT_NEAR(turned.z() - arm.z(), 1e-4 * arm.x() - 2e-4 * arm.y(), 3e-8 * arm.norm());
    EXPECT_NEAR(turned.norm(), arm.norm(), 1e-12);
  }
}

TEST(SynthRegistration, DrawnErrorsHaveTheirSigmasAndTheirSeed) {
  SceneOptions scene = plainScene();
  scene.scanner.count = 400;
  scene.scanner.step = radians(20);
  scene.scanner.registration.sigma_dz = 0.002;
  scene.scanner.registration.sigma_plan = 0.003;
  scene.scanner.registration.sigma_tilt = radians(10.0 / 3600.0);
  double dz = 0.0, plan = 0.0, tilt = 0.0;
  const auto stations = scanStations(Scene(scene));
  for (const ScanStation& s : stations) {
    const RegistrationError& r = s.registration;
    dz += r.dz * r.dz / 400.0;
    plan += (r.dx * r.dx + r.dy * r.dy) / 800.0;
    tilt += (r.tilt_x * r.tilt_x + r.tilt_y * r.tilt_y) / 800.0;
  }
  EXPECT_NEAR(std::sqrt(dz), 0.002, 0.0002);
  EXPECT_NEAR(std::sqrt(plan), 0.003, 0.0002);
  EXPECT_NEAR(degrees(std::sqrt(tilt)) * 3600.0, 10.0, 0.7);
  EXPECT_EQ(scanStations(Scene(scene))[7].registration.dz, stations[7].registration.dz);
  scene.seed += 1;
  EXPECT_NE(scanStations(Scene(scene))[7].registration.dz, stations[7].registration.dz);
}

TEST(SynthRegistration, TruthTellsEachScannersError) {
  RegistrationError error;
  error.dz = 0.004, error.tilt_x = radians(30.0 / 3600.0);
  const auto json = toJson(truthOf(Scene(scenesWith(error)), 8));
  EXPECT_EQ(json["scanners"][0]["registration"]["dz"], 0.004);
  EXPECT_NEAR(json["scanners"][0]["registration"]["tilt_x_arcsec"].get<double>(), 30.0, 1e-9);
}

std::string headerOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text, line;
  while (std::getline(file, line) && line.substr(0, 4) != "DATA") text += line + "\n";
  return text;
}

TEST(SynthRegistration, FilesPerSetupHoldTheViewpointAndMergedOnesALabel) {
  const TestFolder folder;
  RegistrationError error;
  error.dz = 0.25;
  Command command;
  command.scene = scenesWith(error);
  command.scene.scanner.step = radians(10);
  command.scene.scanner.stations = {{18.0, 0.0, 1.5}, {-18.0, 0.0, 1.75}};
  command.scene.offset = {100.0, 200.0, 10.0};
  command.output = folder.path("scan.pcd");
  command.truth = folder.path("truth.json");
  command.split = true;
  writeScan(Scene(command.scene), command);
  EXPECT_NE(headerOf(folder.path("scan_1.pcd")).find("VIEWPOINT 118 200 11.75 1 0 0 0\n"), std::string::npos);
  EXPECT_NE(headerOf(folder.path("scan_2.pcd")).find("VIEWPOINT 82 200 11.75 1 0 0 0\n"), std::string::npos);
  command.split = false;
  command.label_setups = command.ascii = true;
  writeScan(Scene(command.scene), command);
  EXPECT_NE(headerOf(command.output).find("FIELDS x y z intensity setup\n"), std::string::npos);
  std::ifstream file(command.output);
  std::string line, last;
  while (std::getline(file, line)) last = line;
  EXPECT_EQ(last.substr(last.rfind(' ')), " 2");
}

}  // namespace tank_datum::synth::synth_registration_test
