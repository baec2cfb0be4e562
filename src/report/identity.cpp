#include "report/identity.h"

// The parser asserts, and in a release assumes, what damaged files do not hold ("[="); it refuses them as it goes on.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) static_cast<void>(expression)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "core/azimuth.h"
#include "core/printable.h"
#include "core/units.h"
#include "io/io_error.h"
#include "movement/trend.h"
#include "report/logo.h"
#include "stations/ring_series.h"
#include "stations/stations.h"

namespace tank_datum {
namespace {

Error refusedAbout(const std::string& path, const toml::source_region& at, const std::string& value,
                   const std::string& expected) {
  const std::string line = at.begin.line > 0 ? ":" + std::to_string(at.begin.line) : "";
  return {Error::Kind::File, "about", {echoPath(path) + line, value, expected, path}};
}

std::string known() {
  std::string all;
  for (const std::string& key : aboutKeys()) all += key + ", ";
  return all + "logo";
}

/// TOML has none of them, and the parser fails at some.
bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r'; }

toml::table tableOf(const std::string& path) {
  const std::string text = smallFile(path);
  if (std::any_of(text.begin(), text.end(), isControl)) {
    throw refusedAbout(path, {}, "a control character", "TOML: key = \"value\"");
  }
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw refusedAbout(path, error.source(), echo(error.description()), "TOML: key = \"value\"");
  }
}

/// A value as words: texts, dates and numbers.
std::string wordsOf(const toml::node& value, const std::string& path, const std::string& key) {
  if (const auto* text = value.as_string()) {
    if (turnsDirection(text->get())) {
      throw refusedAbout(path, value.source(), key + ": a character that turns the text's direction", "plain text");
    }
    return text->get();
  }
  std::ostringstream out;
  out.imbue(std::locale::classic());
  if (const auto* date = value.as_date()) {
    out << date->get();
  } else if (const auto* number = value.as_integer()) {
    out << number->get();
  } else {
    throw refusedAbout(path, value.source(), key, "a text, a date or a whole number");
  }
  return out.str();
}

/// Refuses a day that there is not; other words may stand for a date, too.
void requireDay(const std::string& date, const toml::source_region& at, const std::string& path) {
  static const std::regex kDay("[0-9]+-[0-9]+-[0-9]+");
  if (!std::regex_match(date, kDay)) return;
  try {
    yearOf(date);
  } catch (const Error&) {
    throw refusedAbout(path, at, "survey_date: " + date, "a day that there is, as 2024-05-31");
  }
}

void readAbout(const std::string& path, Identity& identity) {
  const toml::table table = tableOf(path);
  for (const auto& [key, value] : table) {
    const std::string name(key.str());
    if (name != "logo" && std::find(aboutKeys().begin(), aboutKeys().end(), name) == aboutKeys().end()) {
      throw refusedAbout(path, key.source(), "key " + echo(name), "one of " + known());
    }
  }
  for (const std::string& key : aboutKeys()) {
    const toml::node* const value = table.get(key);
    if (value == nullptr) continue;
    const std::string words = wordsOf(*value, path, key);
    if (key == "survey_date") requireDay(words, value->source(), path);
    identity.about.emplace_back(key, words);
  }
  if (const toml::node* logo = table.get("logo")) identity.logo = logoOf(path, wordsOf(*logo, path, "logo"));
}

Error refusedMark(const std::string& text, const char* expected) {
  return Error(Error::Kind::Option, "options", {"mark", "\"" + echo(text) + "\"", expected});
}

ReferenceMark markOf(const std::string& text) {
  const auto sign = text.rfind('=');
  const auto refused = [&] { return refusedMark(text, "NAME=DEG, as stairs=75"); };
  if (sign == std::string::npos || sign == 0 || turnsDirection(text)) throw refused();
  std::istringstream in(text.substr(sign + 1));
  in.imbue(std::locale::classic());
  double degrees = kUnknown;
  if (!(in >> degrees) || !in.eof() || !(std::abs(degrees) <= 360.0)) throw refused();
  return {text.substr(0, sign), withinTurn(degrees * kDegree)};
}

std::vector<ReferenceMark> marksOf(const std::vector<std::string>& texts) {
  std::vector<ReferenceMark> marks;
  for (const std::string& text : texts) {
    const ReferenceMark mark = markOf(text);
    const bool again = std::any_of(marks.begin(), marks.end(), [&](const auto& m) { return m.name == mark.name; });
    if (again) throw refusedMark(text, "each name once");
    marks.push_back(mark);
  }
  return marks;
}

}  // namespace

const std::vector<std::string>& aboutKeys() {
  static const std::vector<std::string> keys = {"tank",          "product",     "site",       "client",
                                                "company",       "survey_date", "instrument", "inspector",
                                                "report_number", "revision",    "notes"};
  return keys;
}

void readIdentity(RunOptions& run) {
  Identity identity;
  if (!run.about.empty()) readAbout(run.about, identity);
  identity.marks = marksOf(run.marks);
  identity.north = run.north * kDegree;
  identity.survey_points = run.survey_points;
  identity.display_units = run.display_units;
  identity.language = run.language;
  run.identity = std::make_shared<const Identity>(std::move(identity));
}

std::vector<SurveyPoint> surveyPointsOf(const Identity& identity, const std::vector<Station>& stations,
                                        const StationOptions& options) {
  const RingSeries z(stations, &Station::z, &Station::sigma_z), u(stations, &Station::u, &Station::sigma_z);
  std::vector<SurveyPoint> points;
  const double first = std::isfinite(identity.north) ? identity.north : 0.5 * kPi;
  for (int i = 0; i < identity.survey_points && !stations.empty(); ++i) {
    SurveyPoint point;
    point.number = i + 1;
    point.azimuth = azimuthOf(first - kTwoPi * i / identity.survey_points, options);
    if (const auto place = z.placeOf(point.azimuth)) {
      point.z = z.at(point.azimuth)->value;
      point.sigma_z = std::fmax(z.values()[place->before].sigma, z.values()[place->after].sigma);
    }
    if (const auto value = u.at(point.azimuth)) point.u = value->value;
    points.push_back(point);
  }
  return points;
}

void nameTank(Identity& identity, std::size_t number, std::size_t tanks) {
  for (auto& [key, words] : identity.about)
    if (key == "tank" && tanks > 1) words += ", tank_" + std::to_string(number);
}

}  // namespace tank_datum
