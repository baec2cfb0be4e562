#include "shell/shell_bands.h"

#include <algorithm>
#include <cmath>

#include "core/approx_azimuth.h"
#include "core/point_hash.h"
#include "core/portable_math.h"
#include "core/units.h"
#include "locate/crop.h"
#include "locate/foot_unit.h"
#include "locate/ring_shape.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSectors = 720;
constexpr double kPerMetre = 100.0,
                 kMostPlaces = 1e5;  // looked up by height: centimetres [1/footUnit], coarser over kilometres
constexpr double kOneFoot = 0.3;     // API 650 7.5.3: radii are measured 1 ft above the bottom's weld [footUnit]
constexpr double kTallest = 60.0;    // no storage tank's shell is as high [footUnit]
constexpr double kUneven = 0.1;      // of a datum about the coarse plane of its foot [footUnit]

double unitOf(const Tank& tank) { return footUnit(tank.circle.radius, tank.resolution); }

std::vector<double> heightsOf(const ShellOptions& options, double unit) {
  if (!options.heights.empty()) return options.heights;
  std::vector<double> heights;
  for (double height = unit * kOneFoot; height < unit * kTallest;) {
    heights.push_back(height);
    height = unit * kOneFoot + static_cast<double>(heights.size()) * options.step;
  }
  return heights;
}

}  // namespace

ShellBands::ShellBands(const Tank& tank, const ShellOptions& options, std::uint64_t points)
    : side_(tank.side),
      foot_(tank.circle.center.x(), tank.circle.center.y(), tank.foot.coefficients[0]),
      slope_(tank.foot.coefficients[1] / tank.circle.radius, tank.foot.coefficients[2] / tank.circle.radius),
      radius_(tank.circle.radius),
      reach_(reachOf(tank, options.reach) + 2.0 * tank.resolution),
      half_(options.half_band + unitOf(tank) * kUneven + 2.0 * tank.resolution),
      capacity_(static_cast<std::size_t>(static_cast<double>(options.cell_points) * half_ / options.half_band)),
      stride_(points / kPointsLookedAt | 1U),
      heights_(heightsOf(options, unitOf(tank))),
      bands_(heights_.size()) {
  const double widest = reach_ + kSteepestShell * heights_.back();
  inner_ = square(std::max(0.0, radius_ - widest));
  outer_ = square(radius_ + widest);
  const double lowest = heights_.front() - half_;
  const double span = heights_.back() + half_ - lowest;
  per_metre_ = std::min(kPerMetre / unitOf(tank), kMostPlaces / span);
  for (double i = 0.0; i <= std::ceil(span * per_metre_); i += 1.0) {
    const auto band = std::lower_bound(heights_.begin(), heights_.end(), lowest + i / per_metre_ - half_);
    first_band_.push_back(static_cast<std::size_t>(band - heights_.begin()));
  }
}

bool ShellBands::placeOf(const Eigen::Vector3d& p, Place& place) const {
  const Eigen::Vector3d arm = p - foot_;
  const double squared = arm.head<2>().squaredNorm();
  if (squared < inner_ || squared > outer_) return false;
  const double height = arm.z() - slope_.dot(arm.head<2>());
  const double above = (height - heights_.front() + half_) * per_metre_;
  if (!(above >= 0.0 && above < static_cast<double>(first_band_.size()))) return false;
  std::size_t band = first_band_[static_cast<std::size_t>(above)];
  while (band < heights_.size() && heights_[band] < height - half_) ++band;
  if (band == heights_.size() || heights_[band] > height + half_) return false;
  const double widest = reach_ + kSteepestShell * std::abs(height);
  if (squared > (radius_ + widest) * (radius_ + widest)) return false;
  if (widest < radius_ && squared < (radius_ - widest) * (radius_ - widest)) return false;
  place.first = place.end = band;
  while (place.end < heights_.size() && heights_[place.end] <= height + half_) ++place.end;
  place.sector = static_cast<std::size_t>(approxTurn(arm.x(), arm.y()) * kSectors);
  place.hash = pointHash(p);
  return true;
}

bool ShellBands::Kept::isLower(const Kept& a, const Kept& b) {
  if (a.hash != b.hash) return a.hash < b.hash;
  return std::lexicographical_compare(a.point.data(), a.point.data() + 3, b.point.data(), b.point.data() + 3);
}

ShellBands::Cell* ShellBands::Band::made() {
  if (!cells) {
    cells = std::make_unique<Cell[]>(kSectors);
    published.store(cells.get(), std::memory_order_release);
  }
  return cells.get();
}

bool ShellBands::wants(std::size_t band, const Place& place) const {
  const Cell* const cells = bands_[band].seen();
  return cells == nullptr || place.hash < cells[place.sector].limit.load(std::memory_order_relaxed);
}

void ShellBands::gather(std::uint64_t n, const Points& block) {
  thread_local std::vector<Pending> points;
  thread_local std::vector<std::size_t> last;  // of each band
  points.clear();
  last.assign(bands_.size(), Pending::kNone);
  Place place;
  for (std::size_t i = n % stride_; i < block.size(); i += stride_) {
    if (!placeOf(block[i], place)) continue;
    for (std::size_t k = place.first; k < place.end; ++k) {
      if (!wants(k, place)) continue;
      points.push_back({{place.hash, (block[i] - foot_).cast<float>()}, place.sector, last[k]});
      last[k] = points.size() - 1;
    }
  }
  for (std::size_t k = 0; k < last.size(); ++k) {
    if (last[k] == Pending::kNone) continue;
    const std::lock_guard<std::mutex> lock(bands_[k].adding);
    Cell* const cells = bands_[k].made();
    for (std::size_t i = last[k]; i != Pending::kNone; i = points[i].before)
      put(cells[points[i].sector], points[i].kept);
  }
}

void ShellBands::put(Cell& cell, const Kept& kept) const {
  if (kept.hash >= cell.limit.load(std::memory_order_relaxed)) return;
  cell.kept.push_back(kept);
  if (cell.kept.size() < 2 * capacity_) return;
  const auto last = cell.kept.begin() + static_cast<std::ptrdiff_t>(capacity_);
  std::nth_element(cell.kept.begin(), last, cell.kept.end(), Kept::isLower);
  cell.limit = std::uint64_t{last->hash} + 1;
  cell.kept.erase(last, cell.kept.end());
}

Points ShellBands::points(std::size_t height) const {
  Points all;
  const Cell* const cells = bands_[height].seen();
  for (std::size_t sector = 0; cells != nullptr && sector < kSectors; ++sector) {
    std::vector<Kept> sorted = cells[sector].kept;
    std::sort(sorted.begin(), sorted.end(), Kept::isLower);
    sorted.resize(std::min(sorted.size(), capacity_));
    for (const Kept& kept : sorted) all.push_back(kept.point.cast<double>() + foot_);
  }
  return all;
}

}  // namespace tank_datum
