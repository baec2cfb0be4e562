#pragma once

#include <functional>

namespace tank_datum::view {

/// Calls what draws a picture into a file, in a process of its own: where there is no memory or no file to be had the
/// libraries that draw end theirs. Only the file comes of it.
/// @throws Error of `draw`; Error (File) where its process ended without one
void drawApart(const std::function<void()>& draw);

/// Of what a process for drawing was refused.
inline constexpr const char* kRoomToDraw = "enough memory and open files to draw (ulimit -v, ulimit -n)";

}  // namespace tank_datum::view
