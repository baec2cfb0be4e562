#include "print/other_program.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "results/stop_signals.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

bool isProgram(const fs::path& path) { return fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0; }

/// Runs a program in a group of its own, without its words, its temporary files in a folder. It ends with this process.
pid_t start(std::vector<std::string> words, const std::string& temporary) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child > 0) setpgid(child, child);  // the child does so too: whoever comes first
  if (child != 0) return child;
  setpgid(0, 0);
  results::settleChild();
  setenv("TMPDIR", temporary.c_str(), 1);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

/// Whether a program ended well within the time; one that does not is ended.
bool endedWell(pid_t child, std::chrono::seconds within) {
  const auto last = std::chrono::steady_clock::now() + within;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > last) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

std::string findProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) return isProgram(name) ? name : std::string();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (isProgram(fs::path(folder) / name)) return fs::path(folder) / name;
  }
  return {};
}

bool endsWell(std::vector<std::string> words, const Profile& profile, std::chrono::seconds within) {
  std::atomic<pid_t> child = 0;
  const results::OnStop on_stop([&profile, &child] {  // before the program runs: a signal may come as soon as it does
    if (child > 0) kill(-child, SIGKILL);
    profile.remove();
  });
  child = start(std::move(words), profile.path());
  return child > 0 && endedWell(child, within);
}

}  // namespace tank_datum
