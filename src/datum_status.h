#pragma once

#include <string>
#include <vector>

#include "tank_datum/datum.h"

namespace tank_datum {

// How a datum begins and ends: its status and the message that goes with it.

/// What is known of a scan's datum before its first stage.
Datum startDatum(const Scan& scan);

/// A datum that ends here, without stations.
Datum endDatum(Datum datum, Status status, const std::string& message);

/// What one pass over the scan meets.
ScanCounts countsOf(const Scan& scan, int threads);

/// Why there is no tank: no points to speak of, or none that stand like one.
Datum withoutTank(const Scan& scan, const DatumOptions& options);

/// A datum whose tank stands on nothing that was seen.
Datum withoutFoundation(Datum datum, const Scan& scan, const DatumOptions& options);

/// What the stations' elevations mean, and whether there are any.
Datum describeStations(Datum datum, const DatumOptions& options);

/// A datum whose shell, or whose stations, fail a test of whether this is a tank: refused, or doubtful.
Datum judgeTests(Datum datum, const DatumOptions& options);

/// The same of tests that come after those that were judged.
Datum judgeMoreTests(Datum datum, std::vector<TankTest> tests, const DatumOptions& options);

/// Tilt and antipodal inclination of a datum whose level is known, and the status and message that go with them.
Datum finishDatum(Datum datum, const DatumOptions& options);

}  // namespace tank_datum
