#include "results/stop_signals.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <thread>
#include <vector>

namespace tank_datum::results {
namespace {

struct Shared {
  std::recursive_mutex busy;
  std::map<unsigned, std::function<void()>> actions;
  unsigned next = 0;
};

volatile sig_atomic_t came_meanwhile = 0;  // the latest signal, for SignalsWait

void keepForLater(int number) { came_meanwhile = number; }

/// Those from outside that would end the process by default.
std::vector<int> endingSignals() {
  std::vector<int> ending;
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGALRM}) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) ending.push_back(number);
  }
  return ending;
}

/// Never destroyed, since the thread that waits for signals outlives main().
Shared& shared() {
  static Shared* const all = new Shared;
  return *all;
}

void waitAndEnd(const sigset_t& signals, const std::string& program) {
  int number = 0;
  if (sigwait(&signals, &number) == 0) stopBy(number, program);
}

}  // namespace

void cleanUpForGood() {
  shared().busy.lock();  // for good: nobody begins a step any more
  auto& actions = shared().actions;
  for (auto latest = actions.rbegin(); latest != actions.rend(); ++latest) latest->second();
}

void stopBy(int signal_number, const std::string& program) {
  cleanUpForGood();
  std::cerr << program << ": stopped by " << strsignal(signal_number) << "\n" << std::flush;
  signal(signal_number, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, signal_number);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  raise(signal_number);
  std::abort();  // the signal ends the process before
}

void stopCleanly(const std::string& program) {
  sigset_t signals;
  sigemptyset(&signals);
  const std::vector<int> ending = endingSignals();
  for (const int number : ending) sigaddset(&signals, number);
  if (ending.empty()) return;
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, program] { waitAndEnd(signals, program); }).detach();
}

OnStop::OnStop(std::function<void()> cleanUp) {
  const NoStop hold;
  number_ = shared().next++;
  shared().actions[number_] = std::move(cleanUp);
}

OnStop::~OnStop() {
  const NoStop hold;
  shared().actions.erase(number_);
}

NoStop::NoStop() : held_(shared().busy) {}

void settleChild() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nothing, stream);
}

SignalsWait::SignalsWait() : held_(endingSignals()) {
  came_meanwhile = 0;
  struct sigaction later {};
  later.sa_handler = keepForLater;
  later.sa_flags = SA_RESTART;
  for (const int number : held_) sigaction(number, &later, nullptr);
}

SignalsWait::~SignalsWait() {
  for (const int number : held_) signal(number, SIG_DFL);
  if (came_meanwhile != 0) raise(came_meanwhile);
}

}  // namespace tank_datum::results
