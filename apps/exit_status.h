#pragma once

namespace tank_datum {

/// Exit statuses, the same for every executable.
enum ExitStatus {
  kUsable = 0,      ///< a usable result
  kNoDatum = 1,     ///< the data hold no usable datum; results written, their status says why
  kWrongUse = 2,    ///< wrong use or a refused option
  kFileFailed = 3,  ///< a file could not be read or written
};

}  // namespace tank_datum
