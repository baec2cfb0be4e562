#include "measurement.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum::synth {
namespace {

/// Two directions square to the ray and to each other: level and upwards.
struct Across {
  Eigen::Vector3d level, up;

  explicit Across(const Eigen::Vector3d& direction)
      : level(Eigen::Vector3d::UnitZ().cross(direction).normalized()), up(direction.cross(level)) {}

  Eigen::Vector3d turned(const Eigen::Vector3d& direction, double right, double high) const {
    return (direction + right * level + high * up).normalized();
  }
};

/// Range of a beam of some width. Where all of it meets one surface that is the centre's; where it straddles an edge
/// it is the mean over the footprint, always across small gaps (the crease), by chance across large ones.
double beamRange(const Scene& scene, const Ray& ray, int inside, const Hit& centre, Random& random) {
  const MeasurementOptions& o = scene.options().measurement;
  const double radius = (o.beam_diameter / centre.t + o.beam_divergence) / 2.0,
               reach = scene.options().scanner.max_range;
  if (scene.plainAround(ray, centre, inside, radius * centre.t)) return centre.t;
  const Across across(ray.direction);
  const auto part = [&](double right, double high) {
    return scene.cast({ray.origin, across.turned(ray.direction, radius * right, radius * high)}, inside, reach);
  };
  const double rim[4][2] = {{0.0, -1.0}, {0.0, 1.0}, {-1.0, 0.0}, {1.0, 0.0}};
  if (std::all_of(rim, rim + 4, [&](const double* at) { return part(at[0], at[1]).samePlace(centre); }))
    return centre.t;
  constexpr int kParts = 24;
  constexpr double kGolden = 2.399963229728653;  // sunflower: equal areas
  double nearest = centre.t, farthest = centre.t, sum = 0.0, count = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double out = std::sqrt((i + 0.5) / kParts);
    const Hit hit = part(out * portable::cos(i * kGolden), out * portable::sin(i * kGolden));
    if (!hit.found()) continue;
    nearest = std::min(nearest, hit.t), farthest = std::max(farthest, hit.t);
    sum += hit.t, count += 1.0;
  }
  const bool blend = farthest - nearest <= o.blend_gap || random.uniform() < o.blend_probability;
  return blend && count > 0.0 ? sum / count : centre.t;
}

bool nearDatum(const Scene& scene, const Eigen::Vector3d& point, int inside) {
  const double most = scene.options().near_datum;
  if (most == 0.0) return true;
  return std::any_of(scene.tanks().begin(), scene.tanks().end(), [&](const auto& tank) {
    return tank->fromDatum(point, inside >= 0).cwiseAbs().maxCoeff() <= most;
  });
}

bool thinnedAway(const Scene& scene, const Eigen::Vector3d& point, Random& random) {
  const double factor = scene.options().measurement.thin_half;
  const int tank = scene.options().scanner.tank;
  return factor > 1.0 && point.y() < scene.tank(tank).shape.options().y && random.uniform() * factor >= 1.0;
}

}  // namespace

double rangeSigma(const MeasurementOptions& o, double cosine) {
  return o.range_sigma * std::min(o.max_growth, 1.0 + o.incidence_gain * (1.0 / std::max(1e-6, cosine) - 1.0));
}

void measure(const Scene& scene, const ScanStation& station, const Eigen::Vector3d& direction, Random& random,
             Rows& rows) {
  const MeasurementOptions& o = scene.options().measurement;
  Ray ray{station.position, direction};
  if (o.angle_sigma > 0.0) {
    const double right = o.angle_sigma * random.gaussian();
    ray.direction = Across(direction).turned(direction, right, o.angle_sigma * random.gaussian());
  }
  const Hit hit = scene.cast(ray, station.inside, scene.options().scanner.max_range);
  if (!hit.found()) return;
  const double cosine = std::abs(hit.normal.dot(ray.direction));
  double range = o.mixed_pixels ? beamRange(scene, ray, station.inside, hit, random) : hit.t;
  if (o.range_sigma > 0.0) range += rangeSigma(o, cosine) * random.gaussian();
  if (o.outliers > 0.0 && random.uniform() < o.outliers) range = hit.t * random.uniform(0.3, 1.3);
  if (o.quantum > 0.0) range = o.quantum * std::round(range / o.quantum);
  const Eigen::Vector3d point = station.position + range * direction;
  if (range <= 0.0 || !nearDatum(scene, point, station.inside) || thinnedAway(scene, point, random)) return;
  const Eigen::Vector3d said = scene.inFrame(station.registered(point));
  const bool lost = o.invalid > 0.0 && random.uniform() < o.invalid;
  for (Eigen::Index k = 0; k < 3; ++k)
    rows.push_back(lost ? std::nan("") : said[k] + scene.options().offset[static_cast<std::size_t>(k)]);
  rows.push_back(0.1 + 0.8 * cosine);
}

}  // namespace tank_datum::synth
