#pragma once

#include <string>

namespace tank_datum {

/// An image file as a data URI: PNG, JPEG, GIF, WebP by their first bytes, SVG by its first element.
/// @param about  the file that names it; a path is relative to its folder
/// @throws Error (File) when it cannot be read, is none of these, or is larger than 1 MB
std::string logoOf(const std::string& about, const std::string& name);

/// The same of a picture of the viewer, at most 8 MB.
/// @throws Error (File)
std::string pictureOf(const std::string& path);

/// A file of at most 1 MB, whole.
/// @throws Error (File) when it cannot be read, is a folder or a device, or is larger
std::string smallFile(const std::string& path);

}  // namespace tank_datum
