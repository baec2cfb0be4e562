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

/// Cells of what stands before the shell and is too wide for an object, as cladding on a part of the ring: the radius
/// jumps towards where the shell is seen from at its one edge and back at the other. None where that holds of more than
/// half of the cells that show something: then it is not told which of the two is the shell.
/// @param cells     without those of objects
/// @param inside    whether the shell is seen from inside
/// @param thinnest  that is no plate of the shell itself, lapped, let in or put on [m]
std::vector<bool> partsBefore(const ShellCells& cells, bool inside, double thinnest);

}  // namespace tank_datum
