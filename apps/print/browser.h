#pragma once

#include <string>

namespace tank_datum {

/// A Chromium or Chrome among the programs of PATH, or the one named.
/// @param named  a program's name or path; empty: the first found
/// @throws Error (File) when there is none
std::string findBrowser(const std::string& named);

/// By which a PDF is known again: what its field Creator says.
constexpr const char* kPrintMark = "tank_datum_report";

/// Prints a page to a PDF, without a screen. What the browser leaves in the folder for temporary files goes, when a
/// signal ends this process too; of one that was killed with the next run.
/// @param content  the page's text
/// @throws Error (File) when the browser does not write it, or takes longer than two minutes
void printPage(const std::string& browser, const std::string& content, const std::string& pdf);

}  // namespace tank_datum
