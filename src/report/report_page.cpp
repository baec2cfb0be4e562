#include "report/report_page.h"

#include <nlohmann/json.hpp>

#include "report/datum_record.h"
#include "report/report_template.h"
#include "report/section_json.h"
#include "report/shell_report.h"
#include "report/sighting_json.h"
#include "report/text_file.h"
#include "tank_datum/core/error.h"
#include "tank_datum/version.h"

namespace tank_datum {
namespace {

constexpr auto kReplaceBytes = nlohmann::ordered_json::error_handler_t::replace;  // of a path that is no UTF-8

std::string escapedForHtml(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<') {
      escaped += "&lt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

}  // namespace

std::string escapedForScript(const std::string& json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    const bool separator = json.compare(i, 3, "\xE2\x80\xA8") == 0 || json.compare(i, 3, "\xE2\x80\xA9") == 0;
    if (c == '<') {
      escaped += "\\u003c";
    } else if (c == '>') {
      escaped += "\\u003e";
    } else if (c == '&') {
      escaped += "\\u0026";
    } else if (separator) {
      escaped += json[i + 2] == '\xA8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string pageWith(const std::vector<PageData>& data, const std::string& plain) {
  std::string page(kPageBeforeData);
  if (!plain.empty()) page += "<noscript><pre>" + escapedForHtml(plain) + "</pre></noscript>\n";
  for (const PageData& part : data) {
    const bool json = part.type == "application/json";
    if (!json && part.content.find('<') != std::string::npos) {
      throw Error(Error::Kind::Option, "report", part.id, "'<'", "a table of numbers and plain words");
    }
    page += "<script type=\"" + part.type + "\" id=\"data-" + part.id + "\">";
    page += json ? escapedForScript(part.content) : part.content;
    page += "</script>\n";
  }
  return page + std::string(kPageAfterData);
}

namespace {

void addLogo(std::vector<PageData>& data, const std::string& logo) {
  if (!logo.empty()) data.push_back({"logo", "application/json", nlohmann::json(logo).dump()});
}

}  // namespace

std::string reportPage(const Datum& datum, const Provenance& provenance) {
  std::vector<PageData> data = {{"datum", "application/json", datumJson(datum, provenance)},
                                {"stations", "text/csv", stationsCsv(datum)}};
  addLogo(data, provenance.identity.logo);
  if (!datum.sighting.points.empty()) data.push_back({"sighting", "application/json", sightingJson(datum)});
  if (datum.shell.valid()) data.push_back({"shell", "text/csv", shellCsv(datum.shell)});
  if (!datum.refined.sections.empty() && datum.hasStations()) {
    data.push_back({"sections", "application/json", sectionsJson(datum)});
  }
  return pageWith(data, summary(datum, provenance));
}

std::string trendPage(const std::string& movement_json, const std::string& movement_csv, const std::string& logo) {
  std::vector<PageData> data = {{"trend", "application/json", movement_json}, {"movements", "text/csv", movement_csv}};
  addLogo(data, logo);
  return pageWith(data);
}

std::string indexPage(const std::vector<IndexEntry>& tanks) {
  nlohmann::ordered_json index = {{"version", kVersion}, {"files", nlohmann::ordered_json::array()}};
  nlohmann::ordered_json& listed = index["tanks"] = nlohmann::ordered_json::array();
  for (const IndexEntry& entry : tanks) {
    const nlohmann::ordered_json record = datumRecord(entry.datum, entry.provenance);
    for (const char* key : {"display_units", "language"}) {
      if (record.contains(key)) index[key] = record[key];
    }
    nlohmann::ordered_json tank = {{"page", entry.page}};
    for (const char* key : {"status", "message", "tank", "datum", "tilt", "verdict"}) {
      if (record.contains(key)) tank[key] = record[key];
    }
    listed.push_back(std::move(tank));
    if (index["files"].empty()) index["files"] = record["input"]["files"];
  }
  return pageWith({{"index", "application/json", index.dump(-1, ' ', false, kReplaceBytes)}});
}

void writeReportPage(const std::string& folder, const std::string& page) {
  writeTextFile(folder + "/report.html", page);
}

void writeIndexPage(const std::string& folder, const std::string& page) { writeTextFile(folder + "/index.html", page); }

}  // namespace tank_datum
