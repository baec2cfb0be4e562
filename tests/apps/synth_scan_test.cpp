#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/synth_scenes.h"
#include "support/test_folder.h"
#include "synth/measurement.h"
#include "synth/output.h"

namespace tank_datum::synth::synth_scan_test {

/// Range and square deviation of each row from the same scan without noise, and the cosine of its incidence.
struct Residual {
  double range, error, cosine;
};

std::vector<Residual> residuals(const SceneOptions& noisy) {
  SceneOptions clean = noisy;
  clean.measurement = plainScene().measurement;
  const Eigen::Vector3d scanner = scanStations(Scene(noisy))[0].position;
  const Rows a = rowsOf(clean), b = rowsOf(noisy);
  EXPECT_EQ(a.size(), b.size());
  std::vector<Residual> all;
  for (std::size_t i = 0; i < a.size() / 4; ++i) {
    const double truth = (pointOf(a, i) - scanner).norm();
    all.push_back({truth, (pointOf(b, i) - scanner).norm() - truth, (a[4 * i + 3] - 0.1) / 0.8});
  }
  return all;
}

double rms(const std::vector<Residual>& all, double low, double high) {
  double sum = 0.0, count = 0.0;
  for (const Residual& r : all)
    if (r.cosine >= low && r.cosine < high) sum += r.error * r.error, count += 1.0;
  return std::sqrt(sum / count);
}

TEST(SynthScan, NoiseHasTheSigmaAskedFor) {
  SceneOptions options = plainScene();
  options.measurement.range_sigma = 0.002;
  const auto all = residuals(options);
  ASSERT_GT(all.size(), 20000u);
  EXPECT_NEAR(rms(all, 0.0, 1.1), 0.002, 0.00004);
}

TEST(SynthScan, NoiseGrowsWithIncidence) {
  SceneOptions options = plainScene();
  options.measurement.range_sigma = 0.002;
  options.measurement.incidence_gain = 1.0;
  options.measurement.max_growth = 4.0;
  const auto all = residuals(options);
  EXPECT_NEAR(rms(all, 0.98, 1.1), 0.00202, 0.0001);
  EXPECT_NEAR(rms(all, 0.48, 0.52), 0.004, 0.0003);
  EXPECT_NEAR(rms(all, 0.0, 0.2), 0.008, 0.0004);
  EXPECT_DOUBLE_EQ(rangeSigma(options.measurement, 0.5), 0.004);
}

TEST(SynthScan, OutliersHaveTheirFractionAndSpread) {
  SceneOptions options = plainScene();
  options.measurement.outliers = 0.05;
  int moved = 0;
  const auto all = residuals(options);
  for (const Residual& r : all) {
    if (std::abs(r.error) < 1e-9) continue;
    ++moved;
    EXPECT_GE(r.range + r.error, 0.3 * r.range - 1e-9);
    EXPECT_LE(r.range + r.error, 1.3 * r.range + 1e-9);
  }
  EXPECT_NEAR(moved / static_cast<double>(all.size()), 0.05, 0.004);
}

TEST(SynthScan, QuantumRoundsTheRange) {
  SceneOptions options = plainScene();
  options.measurement.quantum = 0.01;
  for (const Residual& r : residuals(options)) EXPECT_NEAR(std::remainder(r.range + r.error, 0.01), 0.0, 1e-9);
}

TEST(SynthScan, AngularNoiseMovesPointsOffTheShell) {
  SceneOptions options = plainScene();
  options.measurement.angle_sigma = radians(0.01);
  const Rows rows = rowsOf(options);
  double worst = 0.0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    const double off = std::abs(std::hypot(rows[4 * i], rows[4 * i + 1]) - 10.0);
    if (rows[4 * i + 2] > 0.5 && rows[4 * i + 3] > 0.5) worst = std::max(worst, off);
  }
  EXPECT_GT(worst, 1e-3);
  EXPECT_LT(worst, 5e-2);
}

TEST(SynthScan, MixedPixelsBlendOnlyAtEdges) {
  SceneOptions options = plainScene();
  ObjectOptions box;
  box.gap = 3.0, box.height = 4.0;
  options.objects = {box};
  options.scanner.step = radians(0.1);
  options.scanner.field = "tank";
  options.measurement.mixed_pixels = true;
  options.measurement.blend_probability = 1.0;
  int between = 0, on_crease = 0, elsewhere = 0;
  const Rows rows = rowsOf(options);
  options.measurement = plainScene().measurement;
  const Rows sharp = rowsOf(options);
  ASSERT_EQ(rows.size(), sharp.size());
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    if ((pointOf(rows, i) - pointOf(sharp, i)).norm() < 1e-9) continue;
    const Eigen::Vector3d p = pointOf(sharp, i);
    const double d = std::hypot(p.x(), p.y()) - 10.0;
    if (std::abs(d) < 0.05 && std::abs(p.z()) < 0.02)
      ++on_crease;
    else if (d < 3.6)
      ++between;
    else
      ++elsewhere;
  }
  EXPECT_GT(on_crease, 50);
  EXPECT_GT(between, 50);
  EXPECT_LT(on_crease + between + elsewhere, static_cast<int>(rows.size() / 4 / 20));
}

TEST(SynthScan, SameSeedSameRowsWhateverTheThreads) {
  SceneOptions options = richScene();
  options.measurement.range_sigma = 0.0015;
  options.measurement.outliers = 0.01;
  const Rows one = rowsOf(options, 1);
  EXPECT_EQ(one, rowsOf(options, 2));
  EXPECT_EQ(one, rowsOf(options, 5));
  options.seed = 2;
  EXPECT_NE(one, rowsOf(options, 1));
}

TEST(SynthScan, OffsetIsAddedToEveryPoint) {
  SceneOptions options = plainScene();
  const Rows plain = rowsOf(options);
  options.offset = {512034.25, 4012877.5, 35.0};
  const Rows moved = rowsOf(options);
  ASSERT_EQ(plain.size(), moved.size());
  for (std::size_t i = 0; i < plain.size() / 4; ++i) {
    const Eigen::Vector3d difference = pointOf(moved, i) - pointOf(plain, i);
    EXPECT_NEAR((difference - Eigen::Vector3d(512034.25, 4012877.5, 35.0)).norm(), 0.0, 2e-9);
  }
}

TEST(SynthScan, ThinHalfMakesAStepOfDensity) {
  SceneOptions options = plainScene();
  options.measurement.thin_half = 10.0;
  const Rows rows = rowsOf(options);
  double south = 0.0, north = 0.0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) (rows[4 * i + 1] < 0.0 ? south : north) += 1.0;
  EXPECT_NEAR(north / south, 10.0, 0.7);
}

TEST(SynthScan, InvalidRowsAreNaN) {
  SceneOptions options = plainScene();
  options.measurement.invalid = 0.02;
  const Rows rows = rowsOf(options);
  double lost = 0.0;
  for (std::size_t i = 0; i < rows.size() / 4; ++i) lost += std::isnan(rows[4 * i]) && std::isnan(rows[4 * i + 2]);
  EXPECT_NEAR(lost / static_cast<double>(rows.size() / 4), 0.02, 0.004);
}

TEST(SynthScan, NearDatumKeepsTheRingOnly) {
  SceneOptions options = plainScene();
  options.near_datum = 0.5;
  const Rows rows = rowsOf(options);
  ASSERT_GT(rows.size(), 400u);
  for (std::size_t i = 0; i < rows.size() / 4; ++i) {
    EXPECT_LE(std::abs(std::hypot(rows[4 * i], rows[4 * i + 1]) - 10.0), 0.5 + 1e-9);
    EXPECT_LE(std::abs(rows[4 * i + 2]), 0.5 + 1e-9);
  }
}

TEST(SynthScan, FieldRowsAndRangeLimitTheRays) {
  SceneOptions options = plainScene();
  const ScanStation full = scanStations(Scene(options))[0];
  EXPECT_EQ(full.columns.size(), 720u);
  EXPECT_EQ(full.rows, 280);
  options.scanner.field = "tank";
  options.scanner.row_step = radians(1.0);
  options.scanner.jitter = false;
  const ScanStation tank = scanStations(Scene(options))[0];
  EXPECT_NEAR(static_cast<double>(tank.columns.size()), 2.0 * degrees(std::asin(11.501 / 18.0)) / 0.5, 2.0);
  EXPECT_EQ(tank.rows, 141);
  EXPECT_EQ(tank.first_azimuth, 0.0);
  options.scanner.max_range = 9.0;
  const Rows rows = rowsOf(options);
  for (std::size_t i = 0; i < rows.size() / 4; ++i) EXPECT_LE((pointOf(rows, i) - tank.position).norm(), 9.0 + 1e-9);
}

TEST(SynthScan, StationsStandWhereAsked) {
  SceneOptions options = plainScene();
  options.scanner.count = 3;
  options.scanner.arc = radians(90);
  options.scanner.first_azimuth = radians(-45);
  const auto generated = scanStations(Scene(options));
  ASSERT_EQ(generated.size(), 3u);
  EXPECT_NEAR(generated[1].position.x(), 18.0, 1e-12);
  EXPECT_NEAR(generated[2].position.y(), 18.0 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(generated[0].position.z(), -0.25 + 1.8, 1e-12);
  options.scanner.stations = {{15.0, 2.0, 3.0}};
  const auto listed = scanStations(Scene(options));
  ASSERT_EQ(listed.size(), 1u);
  EXPECT_EQ(listed[0].position, Eigen::Vector3d(15.0, 2.0, 3.0));
}

TEST(SynthScan, BlocksStaySmallHoweverManyColumns) {
  SceneOptions options = plainScene();
  options.scanner.step = radians(0.1), options.scanner.row_step = radians(0.5);
  std::size_t largest = 0, blocks = 0;
  const ScanSummary summary = scanScene(Scene(options), [&](std::size_t, const Rows& rows) {
    largest = std::max(largest, rows.size() / 4);
    ++blocks;
  });
  EXPECT_GE(blocks, 28u);
  EXPECT_LE(largest, 128u * 281u);
  EXPECT_EQ(summary.rays, 3600u * 280u);
}

TEST(SynthOutput, WritesScanAndTruthOrOneFilePerStation) {
  const TestFolder folder;
  Command command;
  command.output = folder.path("scan.pcd");
  command.truth = folder.path("scan.truth.json");
  command.scene = plainScene();
  command.scene.scanner.count = 2;
  const ScanSummary summary = writeScan(Scene(command.scene), command);
  EXPECT_GT(std::filesystem::file_size(command.output), summary.points * 16);
  EXPECT_LT(std::filesystem::file_size(command.output), summary.points * 16 + 500);
  const auto truth = nlohmann::json::parse(std::ifstream(command.truth));
  EXPECT_EQ(truth["tanks"][0]["stations"].size(), 360u);
  EXPECT_EQ(truth["tanks"][0]["side"], "outside");
  EXPECT_EQ(truth["options"]["tanks"][0]["radius"], 10.0);
  command.split = true;
  command.doubles = true;
  writeScan(Scene(command.scene), command);
  const auto first = std::filesystem::file_size(folder.path("scan_1.pcd")),
             second = std::filesystem::file_size(folder.path("scan_2.pcd"));
  EXPECT_NEAR(static_cast<double>(first + second), static_cast<double>(summary.points * 28), 1000.0);
}

}  // namespace tank_datum::synth::synth_scan_test
