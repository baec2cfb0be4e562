#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>

#include "exit_status.h"
#include "parsed.h"
#include "print/browser.h"
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

/// What the command line asks for.
struct ReportCommand {
  std::string folder, pdf, browser;
};

void addOptions(CLI::App& app, ReportCommand& command) {
  app.add_option("folder", command.folder, "results of tank_datum or tank_datum_compare, with a report.html")
      ->required();
  app.add_option("--pdf", command.pdf, "print the report to this file, on A4")->required();
  app.add_option("--browser", command.browser, "Chromium or Chrome that prints (default: the first in PATH)");
  app.set_version_flag("--version", std::string(kProgram) + " " + kVersion);
}

int run(const ReportCommand& command) {
  const std::string page = command.folder + "/report.html";
  requireApart(inputsOf("result", command.folder), {{"--pdf", command.pdf}});
  settleToRead(command.folder, kProgram);
  if (!std::filesystem::is_regular_file(page)) {
    throw Error(Error::Kind::File, "pdf", page, "not there", "a folder of results with a report");
  }
  const std::string browser = findBrowser(command.browser);
  OutputFile pdf(command.pdf, isFileWith("%PDF", kPrintMark), kProgram);
  printPage(browser, page, pdf.place());
  pdf.commit();
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
