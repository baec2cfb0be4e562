#include "stage_limits.h"

#include <algorithm>
#include <stdexcept>

#include "tank_datum/io/scan.h"
#include "tank_datum/search/normals.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::bench {
namespace {

constexpr double kPoint = sizeof(Points::value_type);
constexpr double kIndex = sizeof(Neighbours::value_type);
constexpr double kNormal = sizeof(Eigen::Vector3f);
constexpr double kShellPoint = sizeof(Eigen::Vector3f);
constexpr double kStation = sizeof(Station);

double real(std::uint64_t count) { return static_cast<double>(count); }

/// Of each row looked at: its bytes, or where rows between are left out at most the line of the cache that it lies in.
double bytesOfRow(const RunSizes& sizes, std::uint64_t looked_at) {
  constexpr double kCacheLine = 64.0;
  return std::min(kCacheLine, real(sizes.file_bytes) / real(looked_at));
}

}  // namespace

std::map<std::string, StageWork> workOf(const RunSizes& sizes) {
  const double neighbours = real(sizes.k) * kIndex;
  const double gathered = kPoint * real(sizes.ring + sizes.search) + kShellPoint * real(sizes.shell);
  return {{"locate", {sizes.located, bytesOfRow(sizes, sizes.located) + kPoint}},
          {"crop", {sizes.cropped, bytesOfRow(sizes, sizes.cropped) + gathered / real(sizes.cropped)}},
          {"setups", {sizes.ring, kPoint}},
          {"normals", {sizes.search, kPoint + neighbours + kNormal}},
          {"region_growing", {sizes.search, neighbours + kNormal}},
          {"centre_filter", {sizes.candidates, kIndex + kPoint}},
          {"spline", {sizes.edge, kPoint}},
          {"refine", {sizes.ring, kPoint}},
          {"deformation", {sizes.stations, kStation}},
          {"shell", {sizes.shell, kShellPoint}},
          {"checks", {sizes.stations, kStation}},
          {"report", {sizes.stations, real(sizes.report_bytes) / real(sizes.stations)}}};
}

StageSpeed speedOf(double seconds, const StageWork& work, double bytes_per_second) {
  const double points = real(work.points);
  if (work.points == 0) return {seconds, kUnknown, kUnknown};
  return {seconds, 1e9 * seconds / points, points * work.bytes_per_point / (seconds * bytes_per_second)};
}

std::vector<StageLimit> limitsOf(const std::vector<StageCost>& one, const std::vector<StageCost>& two,
                                 const std::map<std::string, StageWork>& work, const MemorySpeeds& memory) {
  std::vector<StageLimit> limits;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto known = work.find(one[i].name);
    const StageWork of_stage = known == work.end() ? StageWork() : known->second;
    limits.push_back({one[i].name, of_stage, speedOf(one[i].seconds, of_stage, memory.one),
                      speedOf(two.at(i).seconds, of_stage, memory.two), one[i].seconds / two[i].seconds});
  }
  return limits;
}

void keepFastest(std::vector<StageCost>& best, const std::vector<StageCost>& run) {
  if (best.empty()) best = run;
  for (std::size_t i = 0; i < best.size(); ++i) {
    if (run.at(i).seconds < best[i].seconds) best[i] = run[i];
  }
}

}  // namespace tank_datum::bench
