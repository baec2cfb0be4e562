#pragma once

#include <string>
#include <vector>

#include "tank_datum/datum.h"
#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// An earlier survey that a scan's datum is compared with.
struct Baseline {
  Epoch epoch;
  MovementOptions options;
};

/// Reads an earlier survey, so that what cannot be compared is refused before a long extraction.
/// @param path     a datum.json, or a folder with one
/// @param current  options of the extraction to come: the same method, and the same tank if one is given
/// @throws Error (File) what cannot be read or is no datum.json with its stations; Error (Option) a refused option, a
///         survey without a usable datum, one of another method or of another tank than the one given
Baseline readBaseline(const std::string& path, const MovementOptions& options, const DatumOptions& current);

/// The same for a survey that has been read.
Baseline baselineOf(Epoch survey, const MovementOptions& options, const DatumOptions& current);

/// Refuses a baseline that is of none of the tanks located in a scan, to what the search for tanks can tell.
/// @param origin  of the scan
/// @throws Error (Option) saying how the likest differs
void requireAmong(const std::vector<Tank>& tanks, const Eigen::Vector3d& origin, const Baseline& baseline);

/// The movement of a usable datum since the baseline.
/// @throws Error (Option) as compareEpochs
Movement movementSince(const Baseline& baseline, const Datum& datum, const DatumOptions& current);

}  // namespace tank_datum
