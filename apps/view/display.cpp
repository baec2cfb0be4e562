#include "view/display.h"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <utility>

#include "core/refusal.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"
#include "view/apart.h"

namespace tank_datum::view {
namespace {

constexpr int kNotFound = 127;

/// Becomes Xvfb, which writes its number into a pipe. It ends with the process that asks.
[[noreturn]] void serve(int number) {
  results::settleChild();
  const std::string pipe = std::to_string(number);
  execlp("Xvfb", "Xvfb", "-displayfd", pipe.c_str(), "-nolisten", "tcp", "-screen", "0", "1280x800x24", nullptr);
  _exit(errno == ENOENT ? kNotFound : 1);
}

/// What the pipe says up to the line's end; empty when nobody writes.
std::string lineOf(int pipe) {
  std::string line;
  for (char c = 0; read(pipe, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

}  // namespace

bool displayAnswers() {
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr) return false;
  XCloseDisplay(display);
  return true;
}

VirtualDisplay::VirtualDisplay() {
  int ends[2];
  if (pipe2(ends, 0) != 0) throw refusedBySystem("view", "Xvfb", "", errno, kRoomToDraw);
  server_ = fork();
  if (server_ == 0) {
    close(ends[0]);
    serve(ends[1]);
  }
  const int reason = errno;
  close(ends[1]);
  const std::string number = server_ > 0 ? lineOf(ends[0]) : "";
  close(ends[0]);
  if (server_ < 0) throw refusedBySystem("view", "Xvfb", "", reason, kRoomToDraw);
  if (!number.empty()) {
    setenv("DISPLAY", (":" + number).c_str(), 1);
    return;
  }
  int status = 0;
  waitpid(std::exchange(server_, -1), &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound) return;
  throw Error(Error::Kind::File, "view", "Xvfb", "ended before it had a display", kRoomToDraw);
}

VirtualDisplay::~VirtualDisplay() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);  // upon which it removes its lock
  waitpid(server_, nullptr, 0);
}

}  // namespace tank_datum::view
