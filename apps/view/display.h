#pragma once

#include <sys/types.h>

namespace tank_datum::view {

/// Whether the X display that DISPLAY names answers. VTK crashes without one, so ask before it does.
bool displayAnswers();

/// A display without a screen, for a picture: Xvfb, where PATH has it. DISPLAY names it as long as this lives.
class VirtualDisplay {
 public:
  /// @throws Error (File) where Xvfb was refused what it needs
  VirtualDisplay();
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  bool runs() const { return server_ > 0; }

 private:
  pid_t server_ = -1;
};

}  // namespace tank_datum::view
