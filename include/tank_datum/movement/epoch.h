#pragma once

#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/datum.h"
#include "tank_datum/fit/circle.h"

namespace TANK_DATUM_API tank_datum {

/// A measured elevation of the datum.
struct Elevation {
  double azimuth = kUnknown;    ///< as the survey counts it [rad]
  double direction = kUnknown;  ///< counter-clockwise from +x about the fitted centre [rad]
  double z = kUnknown;          ///< in the scan's own frame [m]
  double sigma_z = kUnknown;    ///< standard error [m]
  double window = kUnknown;     ///< arc along which the points behind z lie; NaN: at the station alone [rad]
};

/// One survey of a tank, as far as surveys are compared.
struct Epoch {
  std::string name;                 ///< where it was read from
  std::string status;               ///< "ok", "partial": usable
  std::string method;               ///< what z is
  std::string surface;              ///< the foundation surface that was intersected; else empty
  Circle circle;                    ///< in the scan's own frame [m]
  std::vector<Elevation> stations;  ///< every one in order; z is NaN where it was not measured
  bool levelled = false;            ///< elevations typed in: its azimuths are about its own centre, (0, 0)

  bool usable() const { return status == "ok" || status == "partial"; }
  std::size_t judgeable() const;  ///< measured stations with a standard error
};

/// The survey in a result, of a scan or of a levelling.
Epoch epochOf(const Datum& datum, Method method, const std::string& name);

/// The file of a survey: itself, or the datum.json in a result folder.
std::string epochFile(const std::string& path);

/// Reads a datum.json, or the one in a result folder. Its `input.kind` says whether it is of a levelling; without one
/// it is of a scan.
/// @throws Error (File) what cannot be read, or is no datum.json with its stations
Epoch readEpoch(const std::string& path);

}  // namespace tank_datum
