#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/units.h"
#include "shape/analysis.h"
#include "shape/deformation.h"
#include "support/made_surveys.h"

namespace tank_datum::made_surveys {

inline std::vector<double> level(std::size_t count) {
  return wave(count, [](double) { return 0.0; });
}

/// Of levelled points.
inline Analysis analysed(const std::vector<double>& z, double radius, double sigma) {
  auto stations = survey(z, radius, sigma);
  const Tilt tilt = fitTilt(stations, {0.0, 0.0}, {});
  const double spacing = kTwoPi * radius / static_cast<double>(z.size());
  return analyse({stations, tilt, radius, {}, {}, widestLevelledGap(spacing)}, AnalysisOptions());
}

/// Whether one of the notes holds a text.
inline bool notes(const Analysis& analysis, const std::string& text) {
  return std::any_of(analysis.notes.begin(), analysis.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

}  // namespace tank_datum::made_surveys
