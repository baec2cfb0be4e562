#pragma once

#include <string>

namespace tank_datum {

/// A report's page with a picture of the viewer in it, which its section "View" shows; one that was in it goes.
/// @param page     the text of a report.html
/// @param picture  a data URI
/// @throws Error (File) when the page is not one of this version
std::string withPicture(const std::string& page, const std::string& picture);

}  // namespace tank_datum
