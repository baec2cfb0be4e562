#pragma once

#include <string>

#include "tank_datum/datum.h"

namespace tank_datum {

/// Points of a station's section for the page: the section is plain with them, and 360 of them take 300 kB.
constexpr int kProfilePoints = 90;

/// The stations' sections as compact JSON for the report's page: per station the base [m, scan's frame], the two lines,
/// and the points as whole tenths of a millimetre; "band" is the part of the foundation that the lines were fitted to
/// [m].
std::string sectionsJson(const Datum& datum);

}  // namespace tank_datum
