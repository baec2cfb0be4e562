#include "movement_files.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tank_datum/error.h"
#include "tank_datum/report_page.h"
#include "tank_datum/statistics.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

std::string text(double value) {
  if (!std::isfinite(value)) return {};
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

struct Trend {
  double slope = std::nan(""), sigma = std::nan("");
};

/// Least squares of one station's dz over survey numbers; the baseline's error is in every dz.
Trend trendOf(const std::vector<Movement>& movements, std::size_t station) {
  const auto count = static_cast<double>(movements.size() + 1);
  const double middle = (count - 1.0) / 2.0, spread = count * (count * count - 1.0) / 12.0;
  Trend trend;
  double slope = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < movements.size(); ++i) {
    if (station >= movements[i].stations.size()) return trend;
    const StationMovement& s = movements[i].stations[station];
    if (s.azimuth != movements.back().stations[station].azimuth || !std::isfinite(s.dz)) return trend;
    const double share = (static_cast<double>(i + 1) - middle) / spread;
    slope += share * s.dz;
    variance += std::abs(share) * s.sigma;  // as if fully correlated: the upper bound
  }
  return {slope, variance};
}

void write(const fs::path& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw Error(Error::Kind::File, "report", path.string(), "not written", "a writable folder with room");
}

}  // namespace

double medianLod(const Movement& movement) {
  std::vector<double> levels;
  for (const StationMovement& s : movement.stations) {
    if (std::isfinite(s.dz)) levels.push_back(s.lod95());
  }
  return median(std::move(levels));
}

std::string movementCsv(const std::vector<Movement>& movements) {
  std::string csv = "azimuth_deg,trend,sigma_trend";
  for (std::size_t i = 1; i <= movements.size(); ++i) {
    const std::string n = std::to_string(i);
    csv += ",dz_" + n + ",lod95_" + n + ",significant_" + n;
  }
  csv += "\n";
  for (std::size_t row = 0; row < movements.back().stations.size(); ++row) {
    const double azimuth = movements.back().stations[row].azimuth;
    const Trend trend = trendOf(movements, row);
    csv += text(std::round(azimuth * (180.0 / 3.14159265358979323846) * 1e10) / 1e10) + "," + text(trend.slope) + "," +
           text(trend.sigma);
    for (const Movement& m : movements) {
      const bool same = row < m.stations.size() && m.stations[row].azimuth == azimuth;
      const StationMovement s = same ? m.stations[row] : StationMovement{};
      csv += "," + text(s.dz) + "," + text(s.lod95()) + "," + (std::isfinite(s.dz) ? s.significant ? "1" : "0" : "");
    }
    csv += "\n";
  }
  return csv;
}

void writeMovement(const std::string& folder, const std::vector<Movement>& movements,
                   const std::vector<Epoch>& epochs) {
  nlohmann::ordered_json json = {{"schema", 1}, {"movements", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < movements.size(); ++i) {
    auto movement = nlohmann::ordered_json::parse(movementJson(movements[i]));
    movement["survey"] = epochs[i + 1].name;
    json["movements"].push_back(movement);
  }
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) throw Error(Error::Kind::File, "report", folder, code.message(), "a folder that can be made");
  const fs::path to(folder);
  using Handler = nlohmann::ordered_json::error_handler_t;
  const std::string text_of_json = json.dump(2, ' ', false, Handler::replace) + "\n";
  write(to / ".movement.json", text_of_json);
  write(to / ".report.html", trendPage(text_of_json));
  write(to / ".movement.csv", movementCsv(movements));
  for (const char* name : {"movement.json", "movement.csv", "report.html"}) {
    fs::rename(to / (std::string(".") + name), to / name, code);
    if (code) throw Error(Error::Kind::File, "report", (to / name).string(), code.message(), "a writable folder");
  }
}

}  // namespace tank_datum
