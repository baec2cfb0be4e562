#pragma once

#include <CLI/CLI.hpp>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "options/option_table.h"

namespace tank_datum {

/// Options of the table as flags of a command line: "setup_error" is --setup-error.
class OptionFlags {
 public:
  /// Declares those that a command can give. `options` hold places that must outlive the parsing.
  OptionFlags(CLI::App& app, const std::vector<Option>& options);
  /// Puts what was typed into the options, in their units.
  /// @throws Error (Option) naming the flag whose text cannot be read
  void putTyped() const;

 private:
  struct Declaration;

  std::deque<double> numbers_;               // as people type them
  std::deque<std::optional<double>> facts_;  // which may be left out
  std::deque<std::string> texts_;            // of what is more than a number
  std::vector<std::pair<const CLI::Option*, std::function<void()>>> to_be_put_;
};

}  // namespace tank_datum
