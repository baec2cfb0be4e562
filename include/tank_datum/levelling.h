#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/datum.h"

namespace TANK_DATUM_API tank_datum {

/// Stations of a levelling survey from a table with the columns azimuth_deg, elevation and, where known, sigma (the
/// standard error of an elevation). An empty elevation is a missing station. Rows may stand in any order.
/// @param file             its name, for messages
/// @param metres_per_unit  of elevation and sigma
/// @param diameter         of the tank [m]
/// @throws Error (Option) naming file, line and what is wrong
std::vector<Station> levellingStations(const std::string& text, const std::string& file, double metres_per_unit,
                                       double diameter, const StationOptions& options);

/// The datum that such stations are, described and judged as that of a scan: about the centre (0, 0).
/// @throws Error (Option) a refused option; elevations further apart than a tenth of the diameter
Datum datumOfLevelling(std::vector<Station> stations, double diameter, const DatumOptions& options);

/// Reads the file, "m", "mm", "ft" or "in" being its units, and describes its datum; with its record.
/// @throws Error  the file cannot be read, or is refused
Datum readLevelling(const std::string& path, double metres_per_unit, double diameter, const DatumOptions& options);

}  // namespace tank_datum
