#include "print/browser.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "print/profile.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpected =
    "Chromium or Chrome in PATH, or a program named; or print report.html from any browser";

bool isProgram(const fs::path& path) { return fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0; }

/// Where PATH has a program; empty where it has not.
std::string inPath(const std::string& name) {
  if (name.find('/') != std::string::npos) return isProgram(name) ? name : std::string();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (isProgram(fs::path(folder) / name)) return fs::path(folder) / name;
  }
  return {};
}

/// A path as an address, so that no character of it means anything else.
std::string addressOf(const std::string& path) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string address = "file://";
  for (const char c : fs::absolute(path).lexically_normal().string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '/' || c == '.' || c == '-' || c == '_') {
      address += c;
    } else {
      address += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return address;
}

/// Runs a program in a group of its own, without its words, its temporary files in a folder. It ends with this process.
pid_t start(std::vector<std::string> words, const std::string& temporary) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child > 0) setpgid(child, child);  // the child does so too: whoever comes first
  if (child != 0) return child;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  setenv("TMPDIR", temporary.c_str(), 1);
  const int nothing = open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) dup2(nothing, stream);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

/// Whether a program ended well within the time; one that does not is ended.
bool endsWell(pid_t child, std::chrono::seconds within) {
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

std::string findBrowser(const std::string& named) {
  std::vector<std::string> names = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"};
  if (!named.empty()) names = {named};
  for (const std::string& name : names) {
    const std::string found = inPath(name);
    if (!found.empty()) return found;
  }
  throw Error(Error::Kind::File, "pdf", named.empty() ? "browser" : named, "not found", kExpected);
}

void printPage(const std::string& browser, const std::string& content, const std::string& pdf) {
  constexpr std::chrono::seconds kLongest(120);
  const Profile profile;
  const std::string page = profile.path() + "/report.html";
  std::ofstream(page, std::ios::binary) << content;
  std::vector<std::string> words = {browser,
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--no-pdf-header-footer",
                                    "--user-data-dir=" + profile.path(),
                                    std::string("--user-agent=") + kPrintMark,
                                    "--print-to-pdf=" + fs::absolute(pdf).string()};
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which Chromium refuses to root
  words.push_back(addressOf(page));
  const pid_t child = start(words, profile.path());
  const results::OnStop on_stop([&profile, child] {
    if (child > 0) kill(-child, SIGKILL);
    profile.remove();
  });
  std::error_code failed;
  if (child < 0 || !endsWell(child, kLongest) || fs::file_size(pdf, failed) == 0 || failed) {
    throw Error(Error::Kind::File, "pdf", pdf, browser + " did not write it", kExpected);
  }
}

}  // namespace tank_datum
