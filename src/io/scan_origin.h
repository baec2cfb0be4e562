#pragma once

#include <memory>
#include <vector>

#include "io/scan_source.h"

namespace tank_datum {

/// The first finite point that is one of the scan, however many others come before it, and not at zero, where scanners
/// write what did not return; zero if there is none.
Eigen::Vector3d findOrigin(const std::vector<std::shared_ptr<const Scan::Source>>& sources);

}  // namespace tank_datum
