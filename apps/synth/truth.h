#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "scanner.h"

namespace tank_datum::synth {

/// The datum at one azimuth, in the frame of the output.
struct TruthStation {
  double azimuth = 0.0;     ///< about the tank's centre, counter-clockwise from +x [rad]
  double x = 0.0, y = 0.0;  ///< [m]
  double z = 0.0;           ///< where the foundation's bare surface, without weld or roughness, meets the shell [m]
  double radius = 0.0;      ///< distance from the centre [m]
  bool covered = false;     ///< soil or ground lies against the shell
  bool visible = false;     ///< some scanner sees the crease, tested by a ray
};

struct TruthTank {
  TankOptions options;
  bool inside = false;  ///< scanned from inside: radius and x, y are those of the inner face
  std::vector<TruthStation> stations;
};

struct Truth {
  SceneOptions options;
  std::vector<Eigen::Vector3d> scanners;  ///< in the frame of the output [m]
  std::vector<TruthTank> tanks;
};

Truth truthOf(const Scene& scene, int stations);

/// The content of truth.json: metres and degrees, in the frame of the output.
nlohmann::ordered_json toJson(const Truth& truth);

}  // namespace tank_datum::synth
