#pragma once

#include <cstddef>

#include "foot/foot_profile.h"

namespace tank_datum {

constexpr double kThickestPlate = 0.03;  ///< annular plate [m]

/// A line through bins of a section.
struct BinLine {
  double offset = 0, slope = 0;  ///< height at the shell [m], [m/m]
  double at(double d) const { return offset + slope * d; }
};

/// Median of the slopes between bins far apart (Theil and Sen), and of the offsets, each weighted by what it is known
/// to: half of the bins but for the corner's may lie off without moving it.
BinLine robustLine(const FootProfile& profile, std::size_t first, std::size_t last);

/// The last bin before the section steps up or down for good: one stray bin is no step.
std::size_t lastBeforeStep(const FootProfile& profile, std::size_t first);

/// Which surface some bins are, by what lies beyond the last of them.
/// @param own  the line through them
Surface surfaceOf(const FootProfile& profile, std::size_t first, std::size_t last, const BinLine& own,
                  const FootScales& scales);

/// Slope of what a lip lies on, and its standard error [m/m].
struct SlopeBeyond {
  double slope = 0, sigma = 0;
};

/// An annular plate lies on the ringwall, so its slope is that of the ringwall's top beyond it, where neither the shell
/// nor the plate's own edge blends into the points; level where no ringwall is seen, or its face alone. Where the
/// ringwall's own edge is seen as well, beams that meet one edge lift a short top's points and those that meet the
/// other lower them: it is read clear of both.
SlopeBeyond slopeBeyond(const FootProfile& profile, std::size_t plate_end, double reach);

/// How high a lip stands above what lies beyond it; of what is none 0 [m].
double dropBeyond(const FootProfile& profile);

/// The same where what passes for a lip may be a cable or a pipe that lies beside the shell: that is seen about as far
/// out as it is high. Else 0 [m].
double heightOfPipe(const FootProfile& profile, double reach);

}  // namespace tank_datum
