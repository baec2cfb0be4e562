#pragma once

#include <string>

#include "tank_datum/core/error.h"

namespace tank_datum {

/// "--setup-error" of "setup_error"
std::string flagOf(const std::string& option);

/// The text for a command line: "option setup_error" becomes "--setup-error".
std::string withFlags(const std::string& text);

/// An error's line, its option by its flag: "options: --k, 2, expected >= 3".
std::string lineOf(const Error& error);

}  // namespace tank_datum
