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

/// The shell at one height above the datum against the circle that fits it best.
struct TruthRound {
  double height = 0.0;                              ///< [m]
  double x = 0.0, y = 0.0, radius = 0.0;            ///< the circle, in the frame of the output [m]
  double max_deviation = 0.0, min_deviation = 0.0;  ///< outwards positive [m]
  double azimuth = 0.0;                             ///< of the larger of the two [rad]
};

/// The shell off the vertical where it is most so, between the lowest and the highest of the heights.
struct TruthPlumb {
  double height = 0.0;   ///< between the two [m]
  double offset = 0.0;   ///< outwards positive [m]
  double azimuth = 0.0;  ///< [rad]
};

struct TruthTank {
  TankOptions options;
  double x = 0.0, y = 0.0;  ///< middle of its base, in the frame of the output [m]
  bool inside = false;      ///< scanned from inside: radius and x, y are those of the inner face
  std::vector<TruthStation> stations;
  // of the shell as it stands, whatever the tilt of the output's frame
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();  ///< of the axis, the tilt's share included [m/m]
  std::vector<TruthRound> rounds;                  ///< 0.3 m above the datum and every metre above that
  TruthPlumb plumb;
};

struct Truth {
  SceneOptions options;
  std::vector<Eigen::Vector3d> scanners;        ///< in the frame of the output [m]
  std::vector<RegistrationError> registration;  ///< of each scanner
  std::vector<TruthTank> tanks;
};

Truth truthOf(const Scene& scene, int stations);

/// The content of truth.json: metres and degrees, in the frame of the output.
nlohmann::ordered_json toJson(const Truth& truth);

}  // namespace tank_datum::synth
