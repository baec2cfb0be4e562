#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace tank_datum::results {

/// Makes the signals that come from outside - SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGXCPU at a limit of time -
/// clean up before the process ends by them. To be called before there are threads: they are taken by a thread of their
/// own. One that the caller ignores stays ignored.
/// @param program  the name that begins the line on stderr
void stopCleanly(const std::string& program);

/// Cleans up, says so on stderr and ends the process by a signal, for a program that hears of its signals otherwise.
[[noreturn]] void stopBy(int signal_number, const std::string& program);

/// What a child process does before it becomes another program: it ends with its parent, hears its signals, and neither
/// reads nor says anything.
void settleChild();

/// Cleans up what a process leaves that is about to end at once.
void cleanUpForGood();

/// What is to be cleaned up when a signal comes, as long as this lives.
class OnStop {
 public:
  explicit OnStop(std::function<void()> cleanUp);
  ~OnStop();
  OnStop(const OnStop&) = delete;
  OnStop& operator=(const OnStop&) = delete;

 private:
  unsigned number_;
};

/// As long as this lives a signal waits: for the steps between which a process must not end.
class NoStop {
 public:
  NoStop();

 private:
  std::unique_lock<std::recursive_mutex> held_;
};

/// As long as this lives, such a signal that would end the process at once waits, and ends it behind; for
/// a process that is not the program's own, whose other handlers stay. One at a time.
class SignalsWait {
 public:
  SignalsWait();
  ~SignalsWait();
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  std::vector<int> held_;
};

}  // namespace tank_datum::results
