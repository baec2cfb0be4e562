#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "io/record_rows.h"
#include "io/scan_source.h"

namespace tank_datum {

/// What a file of rows of fixed length says of its scanner's setups.
struct RecordSetups {
  std::string label_field;                                ///< empty: one setup
  bool zero_is_none = false;                              ///< label 0 stands for no label
  std::optional<Eigen::Vector3d> viewpoint;               ///< of the one setup, in stored units
  std::map<std::uint32_t, ScanBlocks::Setup> known = {};  ///< what the file says of its labels, in stored units
};

/// The points of such a file.
std::shared_ptr<const Scan::Source> recordSource(std::shared_ptr<const InputFile> file, const RecordRows& records,
                                                 double metres_per_unit, RecordSetups setups);

}  // namespace tank_datum
