#include "print/browser.h"

#include <unistd.h>

#include <cctype>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <vector>

#include "print/other_program.h"
#include "print/profile.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpected =
    "Chromium or Chrome in PATH, or a program named; or print report.html from any browser";

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

}  // namespace

std::string findBrowser(const std::string& named) {
  std::vector<std::string> names = {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"};
  if (!named.empty()) names = {named};
  for (const std::string& name : names) {
    const std::string found = findProgram(name);
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
  std::error_code failed;
  if (!endsWell(words, profile, kLongest) || fs::file_size(pdf, failed) == 0 || failed) {
    throw Error(Error::Kind::File, "pdf", pdf, browser + " did not write it", kExpected);
  }
}

}  // namespace tank_datum
