#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tank_datum/datum.h"

namespace tank_datum::view {

/// A datum to look at and the scan it comes from. Lengths in metres relative to `origin`.
struct ViewedResult {
  std::string status, message;  ///< as in datum.json
  bool usable = false;          ///< whether there is a datum; if not, only the fields above are filled
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Circle circle;
  std::vector<Station> stations;
  Points edge_points;
  std::vector<std::pair<std::string, double>> marks;  ///< places at the shell: name and azimuth [rad]
  std::vector<std::string> scans;
  std::string display_units = "mm";  ///< mm, in or ft, of what people read
  double metres_per_unit = 1.0;      ///< of the scans
  std::string up = "z";              ///< which of their axes is up
  std::uint64_t points = 0;          ///< how many they held when the datum was found; 0: not known
};

/// A folder of results as tank_datum writes it.
/// @param scans  where the scans are now; empty: where datum.json says, or beside the folder
/// @throws Error (File) naming the file that is missing or is no result
ViewedResult readResult(const std::string& folder, const std::vector<std::string>& scans);

/// The datum of a scan, extracted with the default options.
/// @throws Error (File)
ViewedResult extractResult(const std::string& scan, double metres_per_unit);

/// The cloud to draw, relative to the result's origin: the scans thinned by voxels to at most `budget` points.
/// @throws Error (File), too when they are not the scans of the result
Points thinnedCloud(const ViewedResult& result, std::size_t budget);

/// The points near the tank, for a picture of it alone.
Points nearTank(const Points& cloud, const ViewedResult& result);

}  // namespace tank_datum::view
