#pragma once

#include <string>

namespace tank_datum {

/// The sheets of a PDF that a browser wrote.
int sheetsOf(const std::string& pdf);

/// A report's page that prints at a share of its size.
std::string shrunk(const std::string& page, const std::string& share);

}  // namespace tank_datum
