#pragma once

#include <cstddef>
#include <vector>

#include "foot/section_lines.h"

namespace tank_datum {

/// The stretches of a section that a line each explains, in order. Of all ways to divide the bins the one that costs
/// least (optimal partitioning, Jackson et al. 2005): what the bins lie off their lines, a steep line, a stretch more,
/// and every bin that is left out because it holds points of two surfaces.
/// @param tolerance  what a surface may be off a line without being another one [m]
std::vector<BinRange> stretchesOf(const std::vector<SectionBin>& bins, double tolerance);

/// What a step is.
struct StepScales {
  double least;   ///< a smaller one is none [m]
  double mixed;   ///< an edge that does not follow the shell, or seen along slanting rays, is as wide as this [m]
  double length;  ///< of the lines on either side [m]
};

/// Number of bins before the section's first step. Stretches are one surface while their lines meet; narrow ones, a
/// blend or a groove, are passed over.
std::size_t binsBeforeStep(const std::vector<SectionBin>& bins, const StepScales& scales);

}  // namespace tank_datum
