#include <algorithm>
#include <cmath>
#include <cstdint>

#include "foot/foot_fit.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {
namespace {

/// Points above a cell of the ground, in two layers.
struct Above {
  std::uint32_t low = 0, high = 0;

  bool isUpright() const {
    constexpr std::uint32_t kFewest = 2;  // of a layer
    return low >= kFewest && high >= kFewest;
  }
};

/// Cells of the ground beside the shell: round the ring, and outwards.
struct GroundCells {
  double size, from;  ///< [m]; from: distance of the first from the shell
  double angle;       ///< [rad]
  std::size_t around, outwards;
  std::vector<Above> above;

  GroundCells(double cell, double first, double reach, double radius) : size(cell), from(first) {
    around = static_cast<std::size_t>(std::max(1.0, std::ceil(kTwoPi * radius / cell)));
    angle = kTwoPi / static_cast<double>(around);
    outwards = static_cast<std::size_t>(std::max(1.0, std::ceil((reach - first) / cell)));
    above.resize(around * outwards);
  }
  bool holds(double d) const { return d >= from && d < from + size * static_cast<double>(outwards); }
  std::size_t column(double azimuth) const {
    return std::min(around - 1, static_cast<std::size_t>(std::max(0.0, azimuth) / angle));
  }
  std::size_t row(double d) const { return static_cast<std::size_t>((d - from) / size); }
  std::size_t at(double azimuth, double d) const { return column(azimuth) * outwards + row(d); }
  /// Of each cell whether something upright stands in it or in one beside it; empty where nothing does.
  std::vector<char> nearUprights() const {
    std::vector<char> near;
    for (std::size_t cell = 0; cell < above.size(); ++cell) {
      if (!above[cell].isUpright()) continue;
      near.resize(above.size());
      const std::size_t c = cell / outwards, r = cell % outwards;
      for (const std::size_t side : {c, (c + 1) % around, (c + around - 1) % around}) {
        for (std::size_t k = r - std::min<std::size_t>(r, 1); k <= std::min(r + 1, outwards - 1); ++k)
          near[side * outwards + k] = 1;
      }
    }
    return near;
  }
};

}  // namespace

void FootRing::leaveOutUprights(const Tank& tank, double nearest, double reach) {
  constexpr double kCell = 1.0 / 15.0;                         // of the reach
  constexpr double kLow = 0.25, kMiddle = 0.625, kHigh = 1.0;  // of the reach above the foot
  if (entries_.empty()) return;
  GroundCells cells(kCell * reach, nearest + kCell * reach, reach, tank.circle.radius);
  std::vector<double> feet;
  for (std::size_t c = 0; c < cells.around; ++c)
    feet.push_back(tank.foot((static_cast<double>(c) + 0.5) * cells.angle));
  for (const Entry& e : entries_) {
    if (!cells.holds(e.d)) continue;
    const double height = (e.z - feet[cells.column(e.azimuth)]) / reach;
    if (height < kLow || height >= kHigh) continue;
    Above& above = cells.above[cells.at(e.azimuth, e.d)];
    ++(height < kMiddle ? above.low : above.high);
  }
  const std::vector<char> near = cells.nearUprights();
  if (near.empty()) return;
  const auto stands = [&](const Entry& e) { return cells.holds(e.d) && near[cells.at(e.azimuth, e.d)] != 0; };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), stands), entries_.end());
}

}  // namespace tank_datum
