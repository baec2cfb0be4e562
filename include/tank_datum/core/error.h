#pragma once

#include <stdexcept>
#include <string>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// A refused value: of which option, what it is, and what it must be.
struct Refusal {
  std::string name;       ///< as the table of options has it, "setup_error"; or the file, row or figure refused
  std::string value;      ///< in the unit that people type
  std::string expected;   ///< ">= 0 m"
  std::string file = {};  ///< path of the file at fault, as it was given; empty: none, or `name` is it
  int system_error = 0;   ///< errno where the system refused the file; 0: its content is at fault
};

/// The one exception of the library. It is thrown when the caller is at fault (a refused option) or the outside
/// world is (a file); what the data say is a status in the result, never an exception.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    Option,  ///< wrong use or a refused option: exit status 2
    File,    ///< a file could not be read or written: exit status 3
  };

  /// The message reads "stage: name, value, expected ...", e.g.
  /// "io: POINTS of scan.pcd, -5, expected a whole number >= 0".
  Error(Kind kind, const std::string& stage, const Refusal& refused)
      : std::runtime_error(stage + ": " + refused.name + ", " + refused.value + ", expected " + refused.expected),
        kind_(kind),
        stage_(stage),
        refused_(refused) {}
  Error(Kind kind, const std::string& stage, const std::string& name, const std::string& value,
        const std::string& expected)
      : Error(kind, stage, {name, value, expected}) {}

  Kind kind() const { return kind_; }
  const std::string& stage() const { return stage_; }
  const Refusal& refused() const { return refused_; }

 private:
  Kind kind_;
  std::string stage_;
  Refusal refused_;
};

}  // namespace tank_datum
