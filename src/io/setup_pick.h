#pragma once

#include "io/scan_source.h"

namespace tank_datum {

/// The labels of a source in rising order; of a format that does not list them they are looked for in a pass.
std::vector<std::uint32_t> labelsIn(const Scan::Source& source);

/// The same source with the points of some labels alone; those of the others are counted as left out.
std::shared_ptr<const Scan::Source> pickedSource(std::shared_ptr<const Scan::Source> source,
                                                 std::vector<std::uint32_t> wanted);

}  // namespace tank_datum
