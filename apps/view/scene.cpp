#include "view/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/units.h"
#include "report/display.h"
#include "shape/deformation.h"
#include "tank_datum/core/unknown.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum::view {
namespace {

constexpr double kRadialRange = 0.05, kDistanceRange = 1.0;  // [m]
constexpr int kPlaneCorners = 72;
constexpr double kPlaneMargin = 1.05;  ///< of the tank's radius

double exaggerated(double z, double mean, double exaggeration) { return mean + exaggeration * (z - mean); }

double directionOf(const ViewedResult& result, double x, double y) {
  const double angle = std::atan2(y - result.circle.center.y(), x - result.circle.center.x());
  return angle < 0.0 ? angle + kTwoPi : angle;
}

/// The datum's elevation in any direction, straight between neighbouring known stations.
class DatumLine {
 public:
  explicit DatumLine(const ViewedResult& result) : result_(result) {
    const double spacing = kTwoPi / static_cast<double>(std::max<std::size_t>(1, result.stations.size()));
    longest_ = 1.5 * spacing;
    for (const Station& s : result.stations) {
      if (std::isfinite(s.z)) knots_.emplace_back(directionOf(result, s.x, s.y), s.z);
    }
    std::sort(knots_.begin(), knots_.end());
  }

  /// NaN in a gap.
  double at(double x, double y) const {
    if (knots_.size() < 2) return kUnknown;
    const double angle = directionOf(result_, x, y);
    const auto next = std::lower_bound(knots_.begin(), knots_.end(), std::make_pair(angle, -HUGE_VAL));
    const auto& b = next == knots_.end() ? knots_.front() : *next;
    const auto& a = next == knots_.begin() ? knots_.back() : *(next - 1);
    const auto from = [](double to, double start) { return std::fmod(to - start + kTwoPi, kTwoPi); };
    const double gap = from(b.first, a.first);
    if (gap > longest_ || gap <= 0.0) return kUnknown;
    return a.second + (b.second - a.second) * from(angle, a.first) / gap;
  }

 private:
  const ViewedResult& result_;
  std::vector<std::pair<double, double>> knots_;  ///< direction [rad], elevation [m]
  double longest_ = 0.0;
};

double share(std::vector<float> values, double part) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

Colouring heights(const Points& cloud, const ViewedResult& result, double range) {
  Colouring colouring{"height above the datum's mean", {}, -range, range};
  const double mean = levelOf(result.stations).mean;
  for (const auto& p : cloud) colouring.values.push_back(static_cast<float>(p.z() - mean));
  if (range > 0.0 || cloud.empty()) return colouring;
  colouring.low = share(colouring.values, 0.01);
  colouring.high = share(colouring.values, 0.99);
  return colouring;
}

Colouring distances(const Points& cloud, const ViewedResult& result, Colour colour, double range) {
  const bool radial = colour == Colour::Radial;
  const double end = range > 0.0 ? range : radial ? kRadialRange : kDistanceRange;
  Colouring colouring{radial ? "distance from the shell's circle" : "distance from the datum", {}, 0.0, end};
  if (radial) colouring.low = -end;
  const DatumLine line(result);
  for (const auto& p : cloud) {
    const double residual = result.circle.residual(p.head<2>());
    const double value = radial ? residual : std::hypot(residual, p.z() - line.at(p.x(), p.y()));
    colouring.values.push_back(static_cast<float>(value));
  }
  return colouring;
}

}  // namespace

std::optional<Refusal> firstError(const SceneOptions& options) {
  const auto refused = [](const char* field, double value, const char* must) {
    std::ostringstream text;
    text << value;
    return Refusal{field, text.str(), must};
  };
  if (!(options.range >= 0.0 && std::isfinite(options.range))) return refused("range", options.range, ">= 0");
  if (!(options.exaggeration >= 1.0 && std::isfinite(options.exaggeration))) {
    return refused("exaggeration", options.exaggeration, ">= 1");
  }
  if (options.points < 1000) return refused("points", static_cast<double>(options.points), ">= 1000");
  if (options.label_every < 0) return refused("labels", options.label_every, ">= 0");
  return std::nullopt;
}

Colouring colouringOf(const Points& cloud, const ViewedResult& result, Colour colour, double range) {
  Colouring colouring =
      colour == Colour::Height ? heights(cloud, result, range) : distances(cloud, result, colour, range);
  const Display::Scale scale = Display(result.display_units).lengths();
  colouring.title += " [" + scale.unit + "]";
  for (float& value : colouring.values) value *= static_cast<float>(scale.factor);
  colouring.low *= scale.factor;
  colouring.high *= scale.factor;
  return colouring;
}

std::vector<Points> curvePieces(const ViewedResult& result, double exaggeration) {
  const auto& stations = result.stations;
  const double mean = levelOf(stations).mean;
  const auto known = [](const Station& s) { return std::isfinite(s.z); };
  const auto gap = std::find_if_not(stations.begin(), stations.end(), known);
  const auto start = static_cast<std::size_t>(gap == stations.end() ? 0 : gap - stations.begin());
  std::vector<Points> pieces;
  bool open = false;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[(start + i) % stations.size()];
    if (known(s)) {
      if (!open) pieces.emplace_back();
      pieces.back().emplace_back(s.x, s.y, exaggerated(s.z, mean, exaggeration));
    }
    open = known(s);
  }
  if (gap == stations.end() && !pieces.empty()) pieces.front().push_back(pieces.front().front());
  return pieces;
}

Points tiltPlane(const ViewedResult& result, double exaggeration) {
  std::vector<Station> stations = result.stations;
  const Tilt tilt = fitTilt(stations, result.circle.center, StationOptions());
  if (!tilt.valid()) return {};
  const double mean = levelOf(stations).mean;
  Points polygon;
  for (int i = 0; i < kPlaneCorners; ++i) {
    const double angle = kTwoPi * i / kPlaneCorners;
    const Eigen::Vector2d arm = kPlaneMargin * result.circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d p = result.circle.center + arm;
    polygon.emplace_back(p.x(), p.y(), exaggerated(tilt.mean + tilt.gradient.dot(arm), mean, exaggeration));
  }
  return polygon;
}

Eigen::Vector3d markOf(const ViewedResult& result, std::size_t station, double exaggeration) {
  const Station& s = result.stations.at(station);
  return {s.x, s.y, exaggerated(s.z, levelOf(result.stations).mean, exaggeration)};
}

int worstStation(const ViewedResult& result) {
  int worst = -1;
  double most = -1.0;
  for (std::size_t i = 0; i < result.stations.size(); ++i) {
    const double u = std::abs(result.stations[i].u);
    if (u > most) worst = static_cast<int>(i), most = u;
  }
  return worst;
}

std::vector<std::pair<std::size_t, std::string>> namedStations(const ViewedResult& result) {
  std::vector<std::pair<std::size_t, std::string>> named;
  const auto count = result.stations.size();
  if (const int worst = worstStation(result); worst >= 0) {
    named.emplace_back(worst, "worst out of plane: " + std::to_string(worst));
  }
  for (const auto& [name, azimuth] : result.marks) {
    const auto at = static_cast<std::size_t>(std::lround(azimuth / kTwoPi * static_cast<double>(count)));
    if (count > 0) named.emplace_back(at % count, name);
  }
  return named;
}

std::vector<std::size_t> numberedStations(const ViewedResult& result, int every) {
  constexpr double kTaken = 10.0 * kDegree;
  std::vector<std::size_t> numbered;
  const auto count = result.stations.size();
  const auto named = namedStations(result);
  for (std::size_t i = 0; every > 0 && i < count; i += static_cast<std::size_t>(every)) {
    const bool taken = std::any_of(named.begin(), named.end(), [&](const auto& place) {
      const std::size_t apart = i > place.first ? i - place.first : place.first - i;
      return kTwoPi * static_cast<double>(std::min(apart, count - apart)) < kTaken * static_cast<double>(count);
    });
    if (!taken) numbered.push_back(i);
  }
  return numbered;
}

std::array<double, 6> boundsOf(const ViewedResult& result, const Points& cloud) {
  constexpr double kNear = 0.05, kMargin = 1.15;  // of the radius
  const double r = result.circle.radius, mean = levelOf(result.stations).mean;
  std::vector<float> heights;
  for (const auto& p : cloud) {
    if (std::abs(result.circle.residual(p.head<2>())) < kNear * r) heights.push_back(static_cast<float>(p.z()));
  }
  const double top = heights.empty() ? mean : static_cast<double>(share(heights, 0.999));
  const Eigen::Vector2d& c = result.circle.center;
  return {c.x() - kMargin * r, c.x() + kMargin * r, c.y() - kMargin * r,
          c.y() + kMargin * r, mean - kNear * r,    std::max(top, mean + kNear * r)};
}

double barLength(double radius) {
  const double power = std::pow(10.0, std::floor(std::log10(radius)));
  for (const double part : {5.0, 2.0}) {
    if (part * power <= radius) return part * power;
  }
  return power;
}

std::string describe(const ViewedResult& result, std::size_t station) {
  const Station& s = result.stations.at(station);
  const auto in = [](const char* format, auto... values) {
    char buffer[160];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return std::string(buffer);
  };
  std::string text = in("station %zu, azimuth %.4g deg", station, s.azimuth * 360.0 / kTwoPi);
  if (!std::isfinite(s.z)) return text + "\nmissing";
  const Display display(result.display_units);
  text += "\nz " + display.longText(s.z + result.origin.z(), 4) + " +- " + display.shortText(2.0 * s.sigma_z, 2);
  text += " (2 sigma)\nx " + display.longText(s.x + result.origin.x());
  text += ", y " + display.longText(s.y + result.origin.y());
  text += "\nradius " + display.longText(s.radius, 4);
  if (std::isfinite(s.u)) text += "\nout of plane " + display.signedShort(s.u) + " " + display.shortUnit();
  return text + (s.flag == StationFlag::Interpolated ? "\ninterpolated" : "\nmeasured");
}

int nearestMark(const std::vector<Eigen::Vector2d>& marks, const Eigen::Vector2d& click, double reach) {
  int nearest = -1;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double distance = (marks[i] - click).norm();
    if (!(distance <= reach)) continue;  // also of a mark that is nowhere
    nearest = static_cast<int>(i);
    reach = distance;
  }
  return nearest;
}

}  // namespace tank_datum::view
