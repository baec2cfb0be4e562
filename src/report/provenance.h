#pragma once

#include <optional>
#include <string>
#include <vector>

#include "movement/baseline.h"
#include "options/run_options.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// What was found, and the record of the file that it was found in.
struct RecordedDatum {
  Datum datum;
  InputRecord file;
};

/// The datum of the levelling survey that a run names.
/// @throws Error  as readLevelling; (File) when the file changes between its reading and its hash
RecordedDatum readRecordedLevelling(const RunOptions& run);

/// The record of a run's datum, with its movement since the baseline. Of several tanks, those that are not the
/// baseline's have a movement that says so.
/// @throws Error  as movementSince, of a run for one tank
Provenance provenanceOf(std::vector<InputRecord> files, const RunOptions& run, const std::optional<Baseline>& baseline,
                        const Datum& datum);

}  // namespace tank_datum
