#include "ground.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum::synth {

double foundationWidth(const Foundation& f) {
  if (f.kind == "pad") return f.pad_width;
  if (f.kind == "annular_plate") return f.ringwall_width;
  return f.slab_width;
}

namespace {

/// Elevation of the ground's plane at x = y = 0: `drop` below the first tank's base at its uphill edge.
double levelAtOrigin(const GroundOptions& ground, const TankOptions& first, double width) {
  const double uphill =
      first.x * portable::cos(ground.slope_direction) + first.y * portable::sin(ground.slope_direction);
  return first.base_elevation - ground.drop - ground.slope * (uphill + first.radius + width);
}

}  // namespace

double depthOfGround(const GroundOptions& ground, const TankOptions& first_tank, double first_width,
                     const TankOptions& tank) {
  if (!ground.present) return 0.5;
  const double uphill = tank.x * portable::cos(ground.slope_direction) + tank.y * portable::sin(ground.slope_direction);
  const double at_centre = levelAtOrigin(ground, first_tank, first_width) + ground.slope * uphill;
  const double edge = tank.radius + foundationWidth(tank.foundation) + 5.0;
  return std::max(0.5, tank.base_elevation - at_centre + ground.slope * edge + 6.0 * ground.roughness + 0.5);
}

Ground::Ground(const GroundOptions& options, const TankOptions& first_tank, double first_width, std::uint64_t seed)
    : options_(options),
      level_(levelAtOrigin(options, first_tank, first_width)),
      slope_x_(options.slope * portable::cos(options.slope_direction)),
      slope_y_(options.slope * portable::sin(options.slope_direction)),
      noise_(mixed({seed, 301}), options.roughness, options.roughness_length) {}

bool Ground::masked(const Tank& tank, const Eigen::Vector3d& world) const {
  const TankOptions& o = tank.shape.options();
  const double reach = o.radius + tank.shape.deviation() + tank.foundation.maskWidth() + 2.0;
  if ((world.head<2>() - Eigen::Vector2d(o.x, o.y)).squaredNorm() > reach * reach) return false;
  const double width = options_.over_foundation ? 0.0 : tank.foundation.maskWidth();
  if (!o.foundation.concentric) return tank.fromDatum(world, false).x() < width;
  return tank.shape.toTank(world).head<2>().norm() < o.radius + width;
}

double Ground::leaveMask(const Tank& tank, const Ray& ray, double t) const {
  const TankShape& shape = tank.shape;
  const TankRay local = shape.local(ray);
  const double width = options_.over_foundation ? 0.0 : tank.foundation.maskWidth();
  const auto gap = [&](double at) {
    const TankPoint p = shape.at(local, at);
    if (shape.options().foundation.concentric) return Sample{shape.options().radius + width - p.rho, -p.rho_rate};
    return Sample{p.section.foot + width - p.rho, p.section.foot_rate * p.azimuth_rate - p.rho_rate};
  };
  const double least = std::max(0.1, std::sqrt(std::max(0.0, local.c - local.b * local.b / local.a)));
  const RayBends bends = shape.bends(local, least);
  return firstRoot(gap, bends.foot + bends.rho, t, kNever) + 1e-9;
}

double Ground::firstPossible(const Ray& ray) const {
  const double above = ray.origin.z() - elevation(ray.origin.x(), ray.origin.y());
  const double rise = ray.direction.z() - slope_x_ * ray.direction.x() - slope_y_ * ray.direction.y();
  return options_.present && rise < 0.0 ? std::max(0.0, (noise_.bound() + 1e-9 - above) / rise) : kNever;
}

void Ground::trace(const Ray& ray, const Tanks& tanks, Hit& hit) const {
  const double begin = firstPossible(ray);
  if (begin >= hit.t) return;
  const Eigen::Vector3d &o = ray.origin, &v = ray.direction;
  const double above = o.z() - elevation(o.x(), o.y()), rise = v.z() - slope_x_ * v.x() - slope_y_ * v.y();
  const double end = std::min(hit.t, (-noise_.bound() - above) / rise + 1e-6);
  const auto gap = [&](double t) {
    const ValueNoise::Height h = noise_.at(o.x() + t * v.x(), o.y() + t * v.y());
    return Sample{above + t * rise - h.value, rise - h.dx * v.x() - h.dy * v.y()};
  };
  const double bend = noise_.bend() * v.head<2>().squaredNorm();
  double t = firstRoot(gap, bend, begin, end);
  for (int i = 0; i < 100 && t < hit.t; ++i) {
    const Eigen::Vector3d place = o + t * v;
    const auto in = std::find_if(tanks.begin(), tanks.end(), [&](const auto& tank) { return masked(*tank, place); });
    if (in == tanks.end()) {
      hit = {t, Surface::Ground, 0, 0, Eigen::Vector3d(-slope_x_, -slope_y_, 1.0).normalized()};
      return;
    }
    t = leaveMask(**in, ray, t);
    if (t < end && gap(t).gap > 0.0) t = firstRoot(gap, bend, t, end);  // else the cut face at the foundation's edge
  }
}

}  // namespace tank_datum::synth
