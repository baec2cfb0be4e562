#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tank_datum/core/error.h"
#include "view/viewed_result.h"

namespace tank_datum::view {

/// What the colour of a point says.
enum class Colour {
  Height,    ///< above the datum's mean
  Radial,    ///< distance from the shell's circle, positive outside
  Distance,  ///< distance from the datum line
};

/// What is drawn, and how.
struct SceneOptions {
  Colour colour = Colour::Height;
  double range = 0.0;          ///< where the colours end [m]; 0: of height 98 % of the points, radial 0.05, distance 1
  double exaggeration = 20.0;  ///< of the curve's and plane's heights about the datum's mean, at least 1
  std::size_t points = 1'000'000;  ///< the most points of the cloud that are drawn, at least 1000
  int label_every = 10;            ///< every N-th station has a label; 0: none
};

/// The first refused field, or nothing.
std::optional<Refusal> firstError(const SceneOptions& options);

/// A number for every point of the cloud, and the ends of the colour scale, in the unit that the title says.
struct Colouring {
  std::string title;
  std::vector<float> values;  ///< NaN where the datum is not known
  double low = 0.0, high = 0.0;
};

/// The numbers behind a colour; of a usable result.
/// @param range  where the scale ends [m]
Colouring colouringOf(const Points& cloud, const ViewedResult& result, Colour colour, double range);

/// The pieces of the datum curve between missing stations, heights exaggerated about the datum's mean; a curve without
/// missing stations is one closed piece whose last point is its first.
std::vector<Points> curvePieces(const ViewedResult& result, double exaggeration);

/// The fitted tilt plane as a polygon somewhat wider than the tank, heights exaggerated as the curve's; empty when the
/// plane was not fitted.
Points tiltPlane(const ViewedResult& result, double exaggeration);

/// Where a station's mark stands beside the curve; NaN of a missing one.
Eigen::Vector3d markOf(const ViewedResult& result, std::size_t station, double exaggeration);

/// The station where the datum is furthest from its plane; -1 where none is known.
int worstStation(const ViewedResult& result);

/// What is written beside single stations: the worst one, and the places that the result names.
std::vector<std::pair<std::size_t, std::string>> namedStations(const ViewedResult& result);

/// The stations that have their number beside them: every N-th, but those whose place a name takes, within 10 degrees.
std::vector<std::size_t> numberedStations(const ViewedResult& result, int every);

/// The ends of what must be in view, in the order of VTK: x, x, y, y, z, z; the shell as high as it is seen.
std::array<double, 6> boundsOf(const ViewedResult& result, const Points& cloud);

/// A round length that fits into the tank's radius, in the radius's unit.
double barLength(double radius);

/// The values of a station, for people, in the scan's frame.
std::string describe(const ViewedResult& result, std::size_t station);

/// The index of the mark nearest to a click, both in pixels; -1 when none is within `reach`.
int nearestMark(const std::vector<Eigen::Vector2d>& marks, const Eigen::Vector2d& click, double reach);

}  // namespace tank_datum::view
