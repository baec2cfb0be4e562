#include "shell_bands.h"

#include <algorithm>
#include <cmath>

#include "point_hash.h"
#include "units.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSectors = 720;
constexpr double kOneFoot = 0.3;    // API 650 7.5.3: radii are measured 1 ft above the bottom's weld [m]
constexpr double kTallest = 60.0;   // no storage tank's shell is as high [m]
constexpr double kSteepest = 0.01;  // of a leaning shell [m/m]
constexpr double kUneven = 0.1;     // of a datum about the coarse plane of its foot [m]

std::vector<double> heightsOf(const ShellOptions& options) {
  if (!options.heights.empty()) return options.heights;
  std::vector<double> heights;
  for (int i = 0; kOneFoot + i * options.step < kTallest; ++i) heights.push_back(kOneFoot + i * options.step);
  return heights;
}

}  // namespace

ShellBands::ShellBands(const Tank& tank, const ShellOptions& options)
    : foot_(tank.circle.center.x(), tank.circle.center.y(), tank.foot.coefficients[0]),
      slope_(tank.foot.coefficients[1] / tank.circle.radius, tank.foot.coefficients[2] / tank.circle.radius),
      radius_(tank.circle.radius),
      reach_(std::min(options.reach, 0.5 * tank.circle.radius) + 2.0 * tank.resolution),
      half_(options.half_band + kUneven + 2.0 * tank.resolution),
      capacity_(static_cast<std::size_t>(static_cast<double>(options.cell_points) * half_ / options.half_band)),
      heights_(heightsOf(options)),
      bands_(heights_.size()) {
  const double widest = reach_ + kSteepest * heights_.back();
  inner_ = std::pow(std::max(0.0, radius_ - widest), 2);
  outer_ = std::pow(radius_ + widest, 2);
}

void ShellBands::put(Cell& cell, std::uint64_t key, const Eigen::Vector3f& p) const {
  const std::uint64_t count = ++cell.seen;
  if (count <= capacity_) {
    cell.kept.push_back(p);
    return;
  }
  const std::uint64_t place = mixed(key * 0x9e3779b97f4a7c15U + count) % count;
  if (place < capacity_) cell.kept[place] = p;
}

bool ShellBands::holds(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d arm = p - foot_;
  const double squared = arm.head<2>().squaredNorm();
  if (squared < inner_ || squared > outer_) return false;
  const double height = arm.z() - slope_.dot(arm.head<2>());
  if (height < heights_.front() - half_ || height > heights_.back() + half_) return false;
  return std::abs(std::sqrt(squared) - radius_) <= reach_ + kSteepest * std::abs(height);
}

void ShellBands::add(const Points& block) {
  for (const auto& p : block) {
    if (!holds(p)) continue;
    const Eigen::Vector3d arm = p - foot_;
    const double height = arm.z() - slope_.dot(arm.head<2>());
    auto band = std::lower_bound(heights_.begin(), heights_.end(), height - half_);
    if (band == heights_.end() || *band > height + half_) continue;
    const double turn = std::atan2(arm.y(), arm.x()) / kTwoPi;
    const auto sector = static_cast<std::size_t>((turn - std::floor(turn)) * kSectors) % kSectors;
    for (; band != heights_.end() && *band <= height + half_; ++band) {
      const auto k = static_cast<std::size_t>(band - heights_.begin());
      if (bands_[k].empty()) bands_[k].resize(kSectors);
      put(bands_[k][sector], k * kSectors + sector, arm.cast<float>());
    }
  }
}

Points ShellBands::points(std::size_t height) const {
  Points all;
  for (const Cell& cell : bands_[height]) {
    for (const auto& p : cell.kept) all.push_back(p.cast<double>() + foot_);
  }
  return all;
}

}  // namespace tank_datum
