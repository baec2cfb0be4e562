#pragma once

namespace tank_datum::view {

/// Whether the X display that DISPLAY names answers. VTK crashes without one, so ask before it does.
bool displayAnswers();

}  // namespace tank_datum::view
