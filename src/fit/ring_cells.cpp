#include "fit/ring_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/fast_floor.h"
#include "core/statistics.h"
#include "core/units.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {

double betweenCells(const std::vector<double>& cells, double azimuth) {
  constexpr std::ptrdiff_t kFurthest = 3;
  const auto count = static_cast<std::ptrdiff_t>(cells.size());
  const double turn = azimuth / kTwoPi;
  const double position = (turn - fastFloor(turn)) * static_cast<double>(count) - 0.5;
  const auto left = static_cast<std::ptrdiff_t>(fastFloor(position));
  const double share = position - static_cast<double>(left);
  const auto cell = [&](std::ptrdiff_t i) {  // i is off by less than a turn
    return cells[static_cast<std::size_t>(i < 0 ? i + count : i >= count ? i - count : i)];
  };
  const double between = (1.0 - share) * cell(left) + share * cell(left + 1);
  if (std::isfinite(between)) return between;
  for (std::ptrdiff_t away = 0; away <= kFurthest; ++away) {
    if (std::isfinite(cell(left - away))) return cell(left - away);
    if (std::isfinite(cell(left + 1 + away))) return cell(left + 1 + away);
  }
  return kUnknown;
}

std::size_t ringCell(double azimuth, std::size_t cells) {
  const double turn = azimuth / kTwoPi;
  return std::min(cells - 1, static_cast<std::size_t>((turn - fastFloor(turn)) * static_cast<double>(cells)));
}

double middleOfCell(std::size_t cell, std::size_t cells) {
  return (static_cast<double>(cell) + 0.5) * kTwoPi / static_cast<double>(cells);
}

double densestOfCell(std::vector<double>& values) {
  constexpr std::size_t kFewest = 5;
  std::sort(values.begin(), values.end());
  return values.size() >= kFewest ? halfSampleMode(values) : kUnknown;
}

}  // namespace tank_datum
