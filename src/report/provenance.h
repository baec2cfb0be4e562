#pragma once

#include <optional>
#include <string>
#include <vector>

#include "movement/baseline.h"
#include "options/run_options.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// The hash of a levelling survey's file and its stations.
/// @throws Error (File) naming it when it cannot be read
InputRecord recordOfLevelling(const std::string& path, const Datum& datum, Checksum checksum);

/// The record of a run's datum, with its movement since the baseline. Of several tanks, those that are not the
/// baseline's have a movement that says so.
/// @throws Error  as movementSince, of a run for one tank
Provenance provenanceOf(std::vector<InputRecord> files, const RunOptions& run, const std::optional<Baseline>& baseline,
                        const Datum& datum);

}  // namespace tank_datum
