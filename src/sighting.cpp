#include "sighting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/clauses.h"
#include "core/plain_text.h"
#include "core/statistics.h"
#include "search/voxel_sample.h"

namespace tank_datum {
namespace {

constexpr std::size_t kShown = 5000;          // points of the picture
constexpr std::uint64_t kLookedAt = 200'000;  // points that these are chosen of
constexpr double kAround = 1.6;               // how far the picture reaches, in radii of the circle tried

/// A sample of the scan, near the circle where there is one.
Points sampleNear(const Circle& circle, const Scan& scan, int threads) {
  Points points = scan.everyNth(scan.size() / kLookedAt | 1U, threads);
  if (circle.valid()) {
    const auto far = [&](const Eigen::Vector3d& p) {
      return (p.head<2>() - circle.center).norm() > kAround * circle.radius;
    };
    points.erase(std::remove_if(points.begin(), points.end(), far), points.end());
  }
  return points.empty() ? points : VoxelSample(points, kShown, 0.001, threads).points();
}

std::string lengthText(double metres) { return fixedText(metres, 3); }

/// How wide the scan is, so that wrong units can be seen.
std::string unitsAdvice(const Points& points) {
  const std::string advice = "Say the units of the scan (option units)";
  if (points.empty()) return advice + ".";
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const Eigen::Vector3d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  char text[100];
  const Eigen::Vector3d wide = high - low;
  snprintfPlain(text, sizeof text, ": what was looked at is %.3g m by %.3g m wide and %.3g m high.", wide.x(), wide.y(),
                wide.z());
  return advice + text;
}

/// Says of a scan that was cut along its shell that it was: "the scan ends 0.1 m outside of the shell: ...".
std::string cutText(const Points& points, const Circle& circle) {
  constexpr double kEnough = 0.2;    // [m], of a foundation
  constexpr double kStrays = 0.001;  // share of the points
  constexpr double kInside = 0.05;   // share of them, of which a floor or a roof has more
  std::vector<double> offs;
  for (const Eigen::Vector3d& p : points) offs.push_back((p.head<2>() - circle.center).norm() - circle.radius);
  if (offs.empty() || quantile(offs, kInside) < -kEnough) return {};
  const double end = quantile(offs, 1.0 - kStrays);
  if (!(end < kEnough)) return {};
  return formatted("the scan ends %.2f m outside of the shell: what it stands on was cut off", std::max(0.0, end));
}

std::string circleAdvice(const Sighting& sighting, const Eigen::Vector3d& origin) {
  if (!sighting.circle.valid()) return "Give the tank's circle, if it is known (option tank), as X,Y,R in metres.";
  const Eigen::Vector2d centre = sighting.circle.center + origin.head<2>();
  return "If the circle in the picture is the tank's, give it (option tank) as " + lengthText(centre.x()) + "," +
         lengthText(centre.y()) + "," + lengthText(sighting.circle.radius) + "; else the right one.";
}

std::vector<std::string> adviceFor(const Datum& datum, const DatumOptions& options) {
  const std::string circle = circleAdvice(datum.sighting, datum.origin), units = unitsAdvice(datum.sighting.points);
  const std::string nearer =
      "Scan the foot from nearer or from more places: the shell and the foundation beside it "
      "must both be seen.";
  switch (datum.status) {
    case Status::NoTank:
      if (datum.sighting.circle.valid())
        return {circle, "Cut away what stands in front of the tank and beside it.", units};
      return {"Look for smaller tanks (option min_radius), which was " + generalText(options.locate.min_radius) + " m.",
              "Say which axis of the scan is up (option up).", units};
    case Status::NoCrease:
      return {nearer, circle, "Say which axis of the scan is up (option up): the foundation must lie below the shell."};
    case Status::TooFewPoints:
      return {"Give the scan before it was thinned, with every setup of the tank.", nearer, units};
    case Status::FitFailed:
      return {"Intersect two surfaces in place of the paper's curve (option method).", nearer, circle};
    case Status::Doubtful:
      return {
          "If the pictures show the tank and its foundation, take it (option accept); its figures are below status "
          "doubtful.",
          circle, nearer};
    default:
      return {};
  }
}

}  // namespace

Datum withSighting(Datum datum, const Scan& scan, const DatumOptions& options) {
  if (datum.usable()) return datum;
  Sighting& sighting = datum.sighting;
  if (datum.tank.circle.valid()) {
    sighting.circle = datum.tank.circle;
    sighting.foot = datum.tank.foot.coefficients.size() > 0 ? datum.tank.foot.coefficients[0] : kUnknown;
  }
  sighting.points = sampleNear(sighting.circle, scan, options.threads);
  if (datum.status == Status::NoCrease) addClause(datum.message, cutText(sighting.points, sighting.circle));
  sighting.advice = adviceFor(datum, options);
  return datum;
}

}  // namespace tank_datum
