#include "growth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <random>

#include "core/units.h"
#include "io/input_file.h"
#include "io/pcd_writer.h"
#include "scratch_folder.h"

namespace tank_datum::bench {
namespace {

/// Gaussian noise fast enough for 10^9 points: drawn once, then read round and round.
class Noise {
 public:
  explicit Noise(double sigma) : values_(kCount) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0.0, sigma);
    for (double& value : values_) value = normal(random);
  }
  double next() { return values_[at_++ % kCount]; }

 private:
  static constexpr std::size_t kCount = 1'000'003;  // a prime: what is repeated is never the same three
  std::vector<double> values_;
  std::size_t at_ = 0;
};

double secondsToRead(const std::string& path) {
  const InputFile file(path);
  std::vector<char> buffer(std::size_t{1} << 17);  // cat's own
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t offset = 0; const std::size_t got = file.readSome(offset, buffer.data(), buffer.size());) {
    offset += got;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

void writeScanOfSize(const GrownScan& scan, const std::string& path) {
  const Scan& source = scan.source;
  const std::uint64_t points = scan.points;
  constexpr double kWidestTurn = 0.025 * kDegree, kNoise = 0.001;
  PcdWriter writer(path, {{"x", 'F', 4}, {"y", 'F', 4}, {"z", 'F', 4}}, PcdWriter::Format::Binary);
  const std::uint64_t repeats = (points + source.size() - 1) / source.size();
  const std::uint64_t all = repeats * source.size();
  const Eigen::Vector3d centre(scan.tank.circle.center.x(), scan.tank.circle.center.y(), 0.0);
  Noise noise(kNoise);
  std::uint64_t row = 0, written = 0;
  std::vector<double> rows;
  for (std::uint64_t repeat = 0; repeat < repeats; ++repeat) {
    const double turn = repeats > 1 ? 2.0 * static_cast<double>(repeat) / static_cast<double>(repeats - 1) - 1.0 : 0.0;
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(turn * kWidestTurn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    source.forEachBlock([&](const Points& block) {
      rows.clear();
      for (const auto& p : block) {
        if (written * all >= points * ++row) continue;
        Eigen::Vector3d moved = turned * (p - centre) + centre + source.origin();
        if (repeats > 1) moved += Eigen::Vector3d(noise.next(), noise.next(), noise.next());
        rows.insert(rows.end(), {moved.x(), moved.y(), moved.z()});
        ++written;
      }
      if (!rows.empty()) writer.append(rows);
    });
  }
  writer.commit();
}

GrowthRun runOfSize(const GrownScan& scan, const DatumOptions& options, Checksum checksum, const std::string& folder) {
  const ScratchFolder scratch(folder);
  const std::string path = scratch.path() + "/scan.pcd";
  writeScanOfSize(scan, path);
  GrowthRun run;
  run.bytes = std::filesystem::file_size(path);
  secondsToRead(path);  // into the page cache, as far as it goes
  run.read_seconds = secondsToRead(path);
  run.chain = runCommand({path}, options, checksum, run.datum);
  return run;
}

double largestInSigmas(const Datum& a, const Datum& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.stations.size(), b.stations.size()); ++i) {
    const Station &s = a.stations[i], &t = b.stations[i];
    if (s.flag != StationFlag::Measured || t.flag != StationFlag::Measured) continue;
    const double apart = s.z + a.origin.z() - t.z - b.origin.z();
    largest = std::max(largest, std::abs(apart) / std::hypot(s.sigma_z, t.sigma_z));
  }
  return largest;
}

}  // namespace tank_datum::bench
