#include "view/viewed_result.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "core/length_units.h"
#include "core/units.h"
#include "io/json_file.h"
#include "io/up_axis.h"
#include "search/voxel_sample.h"
#include "tank_datum/core/error.h"
#include "view/stations_file.h"

namespace tank_datum::view {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Points readPoints(const std::vector<std::string>& paths, double metres_per_unit, const Eigen::Vector3d& origin) {
  Points points;
  const Scan scan = Scan::open(paths, metres_per_unit);
  const Eigen::Vector3d shift = scan.origin() - origin;
  scan.forEachBlock([&](const Points& block) {
    for (const auto& p : block) points.push_back(p + shift);
  });
  return points;
}

/// Where the scan is now: where it was, or beside the folder of results.
std::string found(const std::string& path, const std::string& folder) {
  if (fs::exists(path)) return path;
  const fs::path beside = fs::absolute(folder).lexically_normal() / ".." / fs::path(path).filename();
  if (fs::exists(beside)) return beside.lexically_normal().string();
  throw Error(Error::Kind::File, "view", path, "not there", "the scan where datum.json says, or named by --scan");
}

void fill(ViewedResult& result, const Json& json, const std::string& folder, const std::vector<std::string>& scans) {
  result.status = json.at("status").get<std::string>();
  result.message = json.at("message").get<std::string>();
  result.usable = json.contains("datum");
  if (!result.usable) return;
  const Json& input = json.at("input");
  const auto origin = input.at("origin").get<std::vector<double>>();
  const auto center = json.at("tank").at("center").get<std::vector<double>>();
  result.origin = {origin.at(0), origin.at(1), origin.at(2)};
  result.circle.center = Eigen::Vector2d(center.at(0), center.at(1)) - result.origin.head<2>();
  result.circle.radius = json.at("tank").at("radius").get<double>();
  result.metres_per_unit = kUnits.at(input.at("units").get<std::string>());
  for (const Json& mark : json.value("marks", Json::array())) {
    result.marks.emplace_back(mark.at("name").get<std::string>(), mark.at("azimuth_deg").get<double>() * kDegree);
  }
  if (json.contains("options")) result.up = json.at("options").value("up", result.up);
  result.display_units = json.value("display_units", result.display_units);
  result.scans = scans;
  if (!scans.empty()) return;
  for (const Json& file : input.at("files")) {
    result.points += file.at("points").get<std::uint64_t>();
    result.scans.push_back(found(file.at("path").get<std::string>(), folder));
  }
}

}  // namespace

ViewedResult readResult(const std::string& folder, const std::vector<std::string>& scans) {
  const std::string path = folder + "/datum.json";
  const Json json = readJson(path, "view", "a folder of results of tank_datum");
  ViewedResult result;
  try {
    fill(result, json, folder, scans);
  } catch (const Json::exception& error) {
    throw Error(Error::Kind::File, "view", path, error.what(), "a datum.json of tank_datum");
  } catch (const std::out_of_range&) {
    throw Error(Error::Kind::File, "view", path, "a list too short or an unknown unit", "a datum.json of tank_datum");
  }
  if (!result.usable) return result;
  result.stations = readStations(folder + "/stations.csv", result.origin);
  result.edge_points = readPoints({folder + "/datum_points.pcd"}, 1.0, result.origin);
  return result;
}

ViewedResult extractResult(const std::string& scan, double metres_per_unit) {
  const Datum datum = extractDatum(Scan::open({scan}, metres_per_unit), DatumOptions());
  ViewedResult result;
  result.status = nameOf(datum.status);
  result.message = datum.message;
  result.usable = datum.usable();
  if (!result.usable) return result;
  result.origin = datum.origin;
  result.circle = datum.circle;
  result.stations = datum.stations;
  result.edge_points = datum.edge_points;
  result.scans = {scan};
  result.metres_per_unit = metres_per_unit;
  return result;
}

Points thinnedCloud(const ViewedResult& result, std::size_t budget) {
  const Scan scan = Scan::open(result.scans, result.metres_per_unit).turned(upRotation(result.up));
  if (result.points != 0 && scan.size() != result.points) {
    throw Error(Error::Kind::File, "view", result.scans.front(), std::to_string(scan.size()) + " points",
                "the scan of the result, " + std::to_string(result.points) + " points; or one named by --scan");
  }
  constexpr std::uint64_t kLookedAt = 8;  // points for each that is shown, enough for an even choice
  const Points looked_at = scan.everyNth(scan.size() / (kLookedAt * budget) | 1U);
  Points points = VoxelSample(looked_at, budget).points();
  for (auto& p : points) p += scan.origin() - result.origin;
  return points;
}

Points nearTank(const Points& cloud, const ViewedResult& result) {
  constexpr double kReach = 1.25;  // radii from the axis
  Points near;
  std::copy_if(cloud.begin(), cloud.end(), std::back_inserter(near), [&](const Eigen::Vector3d& p) {
    return (p.head<2>() - result.circle.center).norm() < kReach * result.circle.radius;
  });
  return near;
}

}  // namespace tank_datum::view
