#pragma once

#include <string>

#include "tank_datum/report/report.h"

namespace tank_datum {

/// The hash of a levelling survey's file and its stations.
/// @throws Error (File) naming it when it cannot be read
InputRecord recordOfLevelling(const std::string& path, const Datum& datum, Checksum checksum);

}  // namespace tank_datum
