#pragma once

#include <stdexcept>
#include <string>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// The one exception of the library. It is thrown when the caller is at fault (a refused option) or the outside
/// world is (a file); what the data say is a status in the result, never an exception.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    Option,  ///< wrong use or a refused option: exit status 2
    File,    ///< a file could not be read or written: exit status 3
  };

  /// The message reads "stage: what, value, expected ...", e.g.
  /// "io: POINTS of scan.pcd, -5, expected a whole number >= 0".
  Error(Kind kind, const std::string& stage, const std::string& what, const std::string& value,
        const std::string& expected)
      : std::runtime_error(stage + ": " + what + ", " + value + ", expected " + expected), kind_(kind) {}

  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace tank_datum
