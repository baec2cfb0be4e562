#include "movement/epoch.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "core/plain_text.h"
#include "core/units.h"
#include "io/io_error.h"
#include "io/json_file.h"
#include "movement/epoch_values.h"
#include "movement/trend.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/datum.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostStations = 36'000;  // that --stations gives
constexpr std::size_t kMostChecks = 1000, kMostFactors = 1000;

/// The columns of datum.json's `covariance.factors`, one a station; an unknown station's are zeros.
std::vector<std::vector<double>> sharedErrors(const Json& json, std::size_t stations) {
  std::vector<std::vector<double>> columns(stations);
  const auto covariance = json.find("covariance");
  if (covariance == json.end() || covariance->is_null()) return columns;
  const auto own = covariance->find("independent");
  const auto& factors = covariance->at("factors").get_ref<const Json::array_t&>();
  requireCount(factors.size(), kMostFactors);
  const auto require_one_each = [stations](const Json& errors) {
    if (errors.size() != stations) {
      throw OddValue{std::to_string(errors.size()) + " errors",
                     "one of each of the " + std::to_string(stations) + " stations"};
    }
  };
  if (own != covariance->end()) require_one_each(*own);
  for (const Json& factor : factors) {
    require_one_each(factor);
    for (std::size_t i = 0; i < stations; ++i) {
      const double error = errorFrom(factor.at(i));
      columns[i].push_back(std::isfinite(error) ? error : 0.0);
    }
  }
  return columns;
}

double numberAt(const Json& object, const char* key) { return numberOr(object.value(key, Json(nullptr)), kUnknown); }

/// What was judged, as far as surveys are compared by it.
std::vector<Check> checksFrom(const Json& json) {
  std::vector<Check> checks;
  const Json entries = json.value("checks", Json::array());
  requireCount(entries.size(), kMostChecks);
  for (const Json& entry : entries) {
    Check check;
    check.code = entry.value("code", "");
    check.clause = entry.value("clause", "");
    check.name = entry.value("name", "");
    check.role = entry.value("role", "");
    check.unit = entry.value("unit", "");
    check.value = numberAt(entry, "value"), check.sigma = numberAt(entry, "sigma");
    check.limit = numberAt(entry, "limit");
    checks.push_back(check);
  }
  return checks;
}

/// Free words, or a day that there is.
std::string surveyDate(const Json& json) {
  const Json about = json.value("about", Json::object());
  const std::string date = about.is_object() ? about.value("survey_date", "") : "";
  const bool is_plain = date.find_first_not_of("0123456789-") == std::string::npos;
  if (!is_plain || std::count(date.begin(), date.end(), '-') != 2) return date;
  try {
    yearOf(date);
  } catch (const Error&) {
    throw OddValue{"\"" + echo(date) + "\"", "a day that there is, as 2024-05-31"};
  }
  return date;
}

std::string flagFrom(const Json& station) {
  try {
    return oneOfWords(station.at("flag").get<std::string>(),
                      {nameOf(StationFlag::Measured), nameOf(StationFlag::Interpolated), nameOf(StationFlag::Missing)});
  } catch (OddValue& odd) {
    throw OddValue{"flag " + odd.value, odd.expected};
  }
}

/// What is known of a station that was measured.
void readMeasured(const Json& station, Elevation& e, std::string& part) {
  const std::string place = part;
  part = place + ".z";
  e.z = within(kFarthestPlace, numberOr(station.at("z"), kUnknown));
  part = place + ".sigma_z";
  e.sigma_z = errorFrom(station.at("sigma_z"));
  if (e.sigma_z < kLeastSigma) throw OddValue{shortestText(e.sigma_z), ">= 1e-15 m, or null"};
  part = place + ".window_deg";
  const double window = numberOr(station.value("window_deg", Json(nullptr)), kUnknown);
  if (window < 0.0 || window > 360.0) throw OddValue{shortestText(window), "0 to 360 deg, or null"};
  e.window = toRadians(window);
}

/// Refuses stations that are not round anything.
void requireRound(const std::vector<Elevation>& stations) {
  constexpr double kLeast = 1e-6;  // [rad]
  const auto apart = [&](const Elevation& e) {
    return std::abs(std::remainder(e.direction - stations.front().direction, kTwoPi)) > kLeast;
  };
  if (stations.size() > 1 && std::none_of(stations.begin(), stations.end(), apart)) {
    throw OddValue{generalText(toDegrees(stations.front().direction)) + " of all", "directions round the tank"};
  }
}

/// @param part  of the file that is being read, for messages
Epoch epochFrom(const Json& json, const std::string& path, std::string& part) {
  Epoch epoch;
  epoch.name = path;
  part = "status";
  epoch.status = json.at("status").get<std::string>();
  if (!epoch.usable()) return epoch;
  part = "options.method";
  epoch.method = json.at("options").at("method").get<std::string>();
  part = "datum.surface";
  const Json& surface = json.at("datum").at("surface");
  if (!surface.is_null()) epoch.surface = surface.get<std::string>();
  part = "input.kind";
  const Json input = json.value("input", Json::object());
  epoch.levelled = oneOfWords(input.value("kind", "scan"), {"scan", "levelling"}) == "levelling";
  part = "tank";
  const Json& tank = json.at("tank");
  epoch.circle.center = {within(kFarthestPlace, tank.at("center").at(0).get<double>()),
                         within(kFarthestPlace, tank.at("center").at(1).get<double>())};
  epoch.circle.radius = within(kFarthestPlace, tank.at("radius").get<double>());
  part = "about.survey_date";
  epoch.date = surveyDate(json);
  part = "checks";
  epoch.checks = checksFrom(json);
  part = "stations";
  const auto& stations = json.at("stations").get_ref<const Json::array_t&>();
  requireCount(stations.size(), kMostStations);
  part = "covariance";
  const auto shared = sharedErrors(json, stations.size());
  for (const Json& station : stations) {
    part = "stations[" + std::to_string(epoch.stations.size()) + "]";
    Elevation e;
    e.shared = shared[epoch.stations.size()];
    e.azimuth = toRadians(station.at("azimuth_deg").get<double>());
    e.direction = toRadians(station.at("direction_deg").get<double>());
    if (flagFrom(station) == nameOf(StationFlag::Measured)) readMeasured(station, e, part);
    epoch.stations.push_back(e);
  }
  part = "stations.direction_deg";
  requireRound(epoch.stations);
  return epoch;
}

/// The same; refuses a file of which a part is missing or no such thing.
Epoch epochOfFile(const Json& json, const std::string& name, const std::string& file) {
  std::string part;
  const auto refused = [&](const std::string& what, const std::string& expected) {
    return Error(Error::Kind::File, "epoch", file, part + " " + what, expected);
  };
  try {
    return epochFrom(json, name, part);
  } catch (const Json::exception&) {
    throw refused("missing, or of another type", "a datum.json with its stations");
  } catch (const OddValue& odd) {
    throw refused(odd.value, odd.expected);
  }
}

}  // namespace

std::size_t Epoch::judgeable() const {
  const auto judged = [](const Elevation& e) { return std::isfinite(e.z) && e.sigma_z > 0.0; };
  return static_cast<std::size_t>(std::count_if(stations.begin(), stations.end(), judged));
}

Epoch epochOf(const Datum& datum, Method method, const std::string& name) {
  Epoch epoch;
  epoch.name = name;
  epoch.status = nameOf(datum.status);
  epoch.method = nameOf(method);
  if (datum.refined.valid()) epoch.surface = nameOf(datum.refined.profile.surface);
  epoch.levelled = datum.levelled;
  epoch.checks = datum.analysis.checks;
  epoch.circle = {datum.circle.center + datum.origin.head<2>(), datum.circle.radius};
  const Eigen::MatrixXd& factors = datum.covariance.factors;
  for (const Station& s : datum.stations) {
    Elevation e;
    const auto column = static_cast<Eigen::Index>(epoch.stations.size());
    for (Eigen::Index k = 0; k < (s.flag == StationFlag::Measured ? factors.rows() : 0); ++k) {
      e.shared.push_back(factors(k, column));
    }
    e.azimuth = s.azimuth, e.direction = s.direction;
    if (s.flag == StationFlag::Measured) e.z = s.z + datum.origin.z(), e.sigma_z = s.sigma_z, e.window = s.window;
    epoch.stations.push_back(e);
  }
  return epoch;
}

std::string epochFile(const std::string& path) {
  std::error_code ignored;  // what cannot be looked at cannot be read either, which is said there
  return std::filesystem::is_directory(path, ignored) ? path + "/datum.json" : path;
}

namespace {

/// Refuses a result whose run was stopped while it moved its files into place, as its journal shows: here, or in the
/// folder whose tank_N this is.
void requireWhole(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::absolute(file, ignored).parent_path();
  for (const auto& place : {folder, folder.parent_path()}) {
    if (!std::filesystem::exists(place / ".tank_datum-commit" / "journal.json", ignored)) continue;
    throw Error(Error::Kind::File, "epoch", place.string(), "results incomplete since a run was stopped",
                "a run of tank_datum or tank_datum_compare on it first, which puts it right");
  }
}

}  // namespace

Epoch readEpoch(const std::string& path) {
  const std::string file = epochFile(path);
  requireWhole(file);
  return epochOfFile(readJson(file, "epoch", "a datum.json or a folder with one"), path, file);
}

Epoch epochIn(const std::string& datum_json, const std::string& name) {
  try {
    return epochOfFile(Json::parse(datum_json), name, name);
  } catch (const Json::exception& error) {
    throw Error(Error::Kind::File, "epoch", name, error.what(), "a datum.json with its stations");
  }
}

}  // namespace tank_datum
