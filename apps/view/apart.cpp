#include "view/apart.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "core/refusal.h"
#include "exit_status.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

namespace tank_datum::view {
namespace {

constexpr const char* kPicture = "the picture";

/// An error as it goes through a pipe: each of its texts, and a zero behind it.
std::string sentOf(const Error& error) {
  const Refusal& refused = error.refused();
  std::string sent = error.kind() == Error::Kind::Option ? "option" : "file";
  for (const std::string& text : {error.stage(), refused.name, refused.value, refused.expected}) sent += '\0' + text;
  return sent + '\0';
}

/// Throws what was sent; nothing when that is no whole error.
void throwSent(const std::string& sent) {
  std::vector<std::string> texts;
  std::size_t begin = 0;
  for (std::size_t end; (end = sent.find('\0', begin)) != std::string::npos; begin = end + 1) {
    texts.push_back(sent.substr(begin, end - begin));
  }
  if (texts.size() != 5) return;
  throw Error(texts[0] == "option" ? Error::Kind::Option : Error::Kind::File, texts[1], texts[2], texts[3], texts[4]);
}

[[noreturn]] void drawAndEnd(const std::function<void()>& draw, int pipe) {
  setpgid(0, 0);  // what a terminal sends is for the program, which then ends this one
  results::settleChild();
  try {
    draw();
    _exit(kUsable);
  } catch (const Error& error) {
    const std::string sent = sentOf(error);
    if (write(pipe, sent.data(), sent.size()) < 0) _exit(kFileFailed);
  } catch (const std::exception&) {  // the status says as much
  }
  _exit(kFileFailed);
}

std::string allOf(int pipe) {
  std::string all;
  char block[4096];
  for (ssize_t got; (got = read(pipe, block, sizeof block)) > 0;) all.append(block, static_cast<std::size_t>(got));
  return all;
}

}  // namespace

void drawApart(const std::function<void()>& draw) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw refusedBySystem("view", kPicture, "", errno, kRoomToDraw);
  const pid_t child = fork();
  if (child == 0) drawAndEnd(draw, ends[1]);
  const int reason = errno;
  close(ends[1]);
  const std::string sent = child > 0 ? allOf(ends[0]) : "";
  close(ends[0]);
  if (child < 0) throw refusedBySystem("view", kPicture, "", reason, kRoomToDraw);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == kUsable) return;
  throwSent(sent);
  const std::string end = WIFSIGNALED(status) ? std::string(" (") + strsignal(WTERMSIG(status)) + ")" : "";
  throw Error(Error::Kind::File, "view", kPicture, "not drawn: a library that draws ended" + end, kRoomToDraw);
}

}  // namespace tank_datum::view
