#include "floor.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum::synth {
namespace {

constexpr double kFlatCentre = 0.3;  ///< settlement has faded out at this fraction of the radius
constexpr double kBlunt = 0.5;       ///< the cone's apex is rounded over this radius [m]

}  // namespace

FloorShape::FloorShape(const TankShape& tank, std::uint64_t seed)
    : tank_(tank),
      noise_(mixed({seed, 203}), tank.options().foundation.roughness, tank.options().foundation.roughness_length) {}

/// Elevation and its derivative along a ray.
Sample FloorShape::elevationAlong(const TankPoint& p, const Eigen::Vector3d& v) const {
  const TankOptions& o = tank_.options();
  const double ux = tank_.tiltSlope() * portable::cos(o.tilt_direction),
               uy = tank_.tiltSlope() * portable::sin(o.tilt_direction);
  const double wall = tank_.footRadius(p.section, true), wall_rate = p.section.foot_rate * p.azimuth_rate;
  const double plane = ux * p.position.x() + uy * p.position.y(), plane_rate = ux * v.x() + uy * v.y();
  const double share = p.rho / wall, share_rate = (p.rho_rate - share * wall_rate) / wall;
  const double other =
      p.section.datum - o.base_elevation - plane / share;  // settlement at the wall less the plane there
  const double other_rate = p.section.datum_rate * p.azimuth_rate - (plane_rate - plane * share_rate / share) / share;
  const double t = std::clamp((share - kFlatCentre) / (1.0 - kFlatCentre), 0.0, 1.0);
  const Fade fade(t);
  const double far = std::sqrt(wall * wall + kBlunt * kBlunt), near = std::sqrt(p.rho * p.rho + kBlunt * kBlunt);
  const double cone_rate = o.floor_cone * (wall * wall_rate / far - p.rho * p.rho_rate / near);
  return {o.base_elevation + plane + other * fade.value + o.floor_cone * (far - near),
          plane_rate + other_rate * fade.value + other * fade.rate * share_rate / (1.0 - kFlatCentre) + cone_rate};
}

double FloorShape::elevation(double x, double y) const {
  const double off_centre = x == 0.0 && y == 0.0 ? 1e-9 : 0.0;
  const TankRay still{{x + off_centre, y, 0.0}, Eigen::Vector3d::Zero(), 0.0, 0.0, 0.0, 0.0};
  return elevationAlong(tank_.at(still, 0.0), still.direction).gap;
}

double FloorShape::crossFloor(const TankRay& local, double begin, double end) const {
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(local, t);
    const Sample floor = elevationAlong(p, local.direction);
    const ValueNoise::Height rough = noise_.at(p.position.x(), p.position.y());
    const Eigen::Vector3d& v = local.direction;
    return Sample{p.position.z() - floor.gap - rough.value, v.z() - floor.rate - rough.dx * v.x() - rough.dy * v.y()};
  };
  const Bound& datum = tank_.datumBound();
  const double fading = kFlatCentre * tank_.options().radius;
  const double settlement = (datum.bend + 4.0 * datum.slope + 12.0 * datum.deviation) / (fading * fading);
  const double cone = 2.0 * std::abs(tank_.options().floor_cone) / kBlunt;
  return firstRoot(gap, (settlement + cone + noise_.bend()) * local.a + 1e-6, begin, end);
}

double FloorShape::crossWeld(const TankRay& local, double begin, double end) const {
  const double leg = tank_.options().foundation.weld;
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(local, t);
    const double from_wall = tank_.footRadius(p.section, true) - p.rho;
    return Sample{p.h + from_wall - leg, p.h_rate + p.section.foot_rate * p.azimuth_rate - p.rho_rate};
  };
  const auto within = [&](double t) {
    const TankPoint p = tank_.at(local, t);
    return p.h >= -noise_.bound() && p.h <= leg;
  };
  const RayBends bends = tank_.bends(local, 0.5 * tank_.options().radius);
  return firstAcceptedRoot(gap, bends.datum + bends.foot + bends.rho, begin, end, within);
}

void FloorShape::trace(const TankRay& local, int owner, Hit& hit) const {
  const TankOptions& o = tank_.options();
  const double highest = tank_.datumBound().deviation + std::abs(o.floor_cone) * o.radius + noise_.bound();
  const double top = o.base_elevation + highest + o.foundation.weld + 1e-6;
  if (local.direction.z() >= 0.0 && local.origin.z() > top) return;
  const double down = local.direction.z() < 0.0 ? (top - local.origin.z()) / local.direction.z() : 0.0;
  double ignored, wall;
  if (!local.within(o.radius + tank_.deviation(), ignored, wall)) return;
  const double begin = std::max(0.0, down), end = std::min(wall, hit.t);
  const double t = crossFloor(local, begin, end);
  if (t < hit.t) {
    constexpr double step = 1e-5;
    const Eigen::Vector3d p = local.origin + t * local.direction;
    const double dx = elevation(p.x() + step, p.y()) - elevation(p.x() - step, p.y());
    const double dy = elevation(p.x(), p.y() + step) - elevation(p.x(), p.y() - step);
    hit = {t, Surface::Floor, owner, 0, tank_.worldNormal({-dx / (2.0 * step), -dy / (2.0 * step), 1.0})};
  }
  if (o.foundation.weld == 0.0) return;
  double near_wall;  // the weld is met on the way out only
  if (!local.within(o.radius - tank_.deviation() - o.thickness - 2.0 * o.foundation.weld, ignored, near_wall))
    near_wall = 0.0;
  const double weld = crossWeld(local, std::max(begin, near_wall), std::min(end, hit.t));
  if (weld >= hit.t) return;
  const TankPoint p = tank_.at(local, weld);
  const Eigen::Vector3d gradient(-p.position.x() / p.rho, -p.position.y() / p.rho, 1.0);
  hit = {weld, Surface::Weld, owner, 0, tank_.worldNormal(gradient)};
}

}  // namespace tank_datum::synth
