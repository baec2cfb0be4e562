#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "tank_datum/core/export.h"
#include "tank_datum/core/unknown.h"

namespace TANK_DATUM_API tank_datum {

enum class TestOutcome {
  Pass,
  Doubtful,  ///< something like a tank, that fails this test
  Fail,      ///< no tank
};

/// What one test says of whether the thing found is a tank.
struct TankTest {
  std::string name;         ///< as in datum.json: behind, round, on_circle, ...
  double value = kUnknown;  ///< what was found, in the unit of the limit
  double limit = kUnknown;  ///< beyond it the thing is doubtful
  std::string unit;         ///< "1", "deg", "stations"
  TestOutcome outcome = TestOutcome::Pass;
  std::string finding;  ///< "points lie 3 m behind it over 60 % of what is seen"
};

/// The name used in files: "pass", "doubtful", "fail".
const char* nameOf(TestOutcome outcome);

/// How a shell leans as a whole: its axis, seen from above.
struct ShellLean {
  Eigen::Vector2d slope = Eigen::Vector2d::Constant(kUnknown);  ///< of the axis: metres sideways a metre up
  double sigma = kUnknown;                                      ///< standard error of either part [m/m]

  bool known() const { return sigma > 0.0 && slope.allFinite(); }
  /// The axis of the shell, upwards, of length 1.
  Eigen::Vector3d axis() const { return Eigen::Vector3d(slope.x(), slope.y(), 1.0).normalized(); }
};

}  // namespace tank_datum
