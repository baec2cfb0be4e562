#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "exit_status.h"
#include "parsed.h"
#include "print/browser.h"
#include "print/pictured_page.h"
#include "print/sheets.h"
#include "print/viewer.h"
#include "report/logo.h"
#include "results/file_calls.h"
#include "results/manifest.h"
#include "results/output_file.h"
#include "results/output_guard.h"
#include "results/result_folder.h"
#include "run_main.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

constexpr const char* kProgram = "tank_datum_report";
constexpr const char* kNoPicture = "none";

/// What the command line asks for.
struct ReportCommand {
  std::string folder, pdf, html, picture, browser;
};

void addOptions(CLI::App& app, ReportCommand& command) {
  app.add_option("folder", command.folder, "results of tank_datum or tank_datum_compare, with a report.html")
      ->required();
  app.add_option("--pdf", command.pdf, "print the report to this file, on A4");
  app.add_option("--html", command.html, "write the report to this file, to be mailed with the picture in it");
  app.add_option("--picture", command.picture,
                 "the image that the report shows, at most 8 MB; none: without (default: tank_datum_view draws one)");
  app.add_option("--browser", command.browser, "Chromium or Chrome that prints (default: the first in PATH)");
  app.set_version_flag("--version", std::string(kProgram) + " " + kVersion);
}

/// The picture that the page is to show; empty: none.
std::string pictureFor(const ReportCommand& command) {
  if (command.picture.empty()) return drawnPicture(command.folder);
  return command.picture == kNoPicture ? "" : pictureOf(command.picture);
}

/// The page with what is to be put into it.
std::string pageOf(const ReportCommand& command) {
  const std::string path = command.folder + "/report.html";
  if (!std::filesystem::is_regular_file(path)) {
    throw Error(Error::Kind::File, "report", path, "not there", "a folder of results with a report");
  }
  const std::string page = results::contentOf(path);
  const std::string picture = pictureFor(command);
  return picture.empty() ? page : withPicture(page, picture);
}

/// On five sheets, smaller where it takes more; what takes more even so is printed as it is then.
void print(const ReportCommand& command, const std::string& browser, const std::string& page) {
  constexpr int kMostSheets = 5;
  OutputFile pdf(command.pdf, isFileWith("%PDF", kPrintMark), kProgram);
  for (const char* share : {"1", "0.93", "0.86", "0.8"}) {
    std::filesystem::remove(pdf.place());
    printPage(browser, shrunk(page, share), pdf.place());
    if (sheetsOf(pdf.place()) <= kMostSheets) break;
  }
  pdf.commit();
}

void write(const ReportCommand& command, const std::string& page) {
  OutputFile html(command.html, isReportPage(), kProgram);
  html.write(page);
  html.commit();
}

int run(const ReportCommand& command) {
  if (command.pdf.empty() && command.html.empty()) {
    throw Error(Error::Kind::Option, "command line", "--pdf", "not given", "a file for the report: --pdf or --html");
  }
  std::vector<NamedPath> inputs = inputsOf("result", command.folder);
  if (command.picture != kNoPicture) inputs.push_back({"picture", command.picture});
  requireApart(inputs, {{"--pdf", command.pdf}, {"--html", command.html}});
  if (!command.pdf.empty()) requireApart({{"--pdf", command.pdf}}, {{"--html", command.html}});
  settleToRead(command.folder, kProgram);
  const std::string browser = command.pdf.empty() ? "" : findBrowser(command.browser);
  const std::string page = pageOf(command);
  if (!command.html.empty()) write(command, page);
  if (!command.pdf.empty()) print(command, browser, page);
  return kUsable;
}

}  // namespace
}  // namespace tank_datum

int main(int argc, char** argv) {
  using namespace tank_datum;
  return runMain(kProgram, [&]() -> int {
    CLI::App app("A tank's report on paper.", kProgram);
    ReportCommand command;
    addOptions(app, command);
    int status = kUsable;
    return parsed(app, argc, argv, status) ? run(command) : status;
  });
}
