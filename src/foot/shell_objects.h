#pragma once

#include <vector>

namespace tank_datum {

/// Radii of a shell in equal cells round the ring.
struct ShellCells {
  std::vector<double> radius;  ///< [m], NaN where nothing stands
  double noise;                ///< of one radius [m]
  double arc;                  ///< of a cell [m]
};

/// By how much a shell's radius may change along an arc [m]: a lobe of +-50 mm over 3 m turns it by 0.1 against the
/// circle.
double mostTurn(const ShellCells& cells, double arc);

/// The radii without those of objects that stand before the shell, such as anchor chairs, pipes or stairs. An object
/// has an edge on either side, at which the radius jumps, and the same way as seen from the cells beside. The
/// shortest are taken out first, so that of many objects and the shell between them the shell is left. What is as wide
/// as an eighth of the ring is none.
std::vector<double> withoutObjects(const ShellCells& cells);

}  // namespace tank_datum
