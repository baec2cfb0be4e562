#include "shell.h"

#include <algorithm>
#include <cmath>

namespace tank_datum::synth {
namespace {

constexpr double kBelowDatum = 0.15;  ///< the shell goes on this far, behind foundation roughness [m]

/// Radius of one face at the point and its derivatives along the ray, by azimuth and by height.
struct Face {
  double radius, along, by_azimuth, by_height;
};

Face faceAt(const TankShape& tank, const TankPoint& p, bool inner) {
  const TankOptions& o = tank.options();
  const double sign = inner ? -1.0 : 1.0;
  Face face;
  face.radius = inner ? tank.innerRadius(p.section, p.h) : tank.outerRadius(p.section, p.h);
  face.by_height = p.section.growth / o.height + (tank.stepped(inner) ? sign * tank.courseRate(p.h) : 0.0);
  const double fixed_h = p.section.foot_rate + p.section.growth_rate * p.h / o.height;
  face.by_azimuth = fixed_h - face.by_height * p.section.datum_rate;
  face.along = fixed_h * p.azimuth_rate + face.by_height * p.h_rate;
  return face;
}

/// Bound of the radius's second derivative along the ray between two parameters.
double radiusBend(const TankShape& tank, const TankRay& ray, const RayBends& bends, double begin, double end) {
  const TankOptions& o = tank.options();
  const double z0 = ray.origin.z() + begin * ray.direction.z(), z1 = ray.origin.z() + end * ray.direction.z();
  const double base = o.base_elevation, spread = tank.datumBound().deviation;
  const double h_low = std::min(z0, z1) - base - spread, h_high = std::max(z0, z1) - base + spread;
  const double highest = std::max(std::abs(h_low), std::abs(h_high)) / o.height;
  const double course = tank.courseBend(h_low, h_high);
  const double slope = course == 0.0 ? 0.0 : 0.5;  // of the taper: 1.875 / 4
  return bends.foot + bends.growth * (1.0 + highest) + bends.datum * (slope + tank.deviation() / o.height) +
         course * bends.h_rate * bends.h_rate;
}

bool onShell(const TankShape& tank, double h) { return h >= -kBelowDatum && h <= tank.options().height; }

/// The hit of a ray that crosses a face at the parameter t.
Hit hitAt(const TankShape& tank, const TankPoint& p, const Face& face, double t, int owner) {
  const double cosine = p.position.x() / p.rho, sine = p.position.y() / p.rho, turn = -face.by_azimuth / p.rho;
  const Eigen::Vector3d normal = tank.worldNormal({cosine - turn * sine, sine + turn * cosine, -face.by_height});
  return {t, Surface::Shell, owner, 0, normal};
}

}  // namespace

void traceShell(const TankShape& tank, const TankRay& local, int owner, Hit& hit) {
  double begin, end;
  const double low = tank.options().radius - tank.deviation(), high = tank.options().radius + tank.deviation();
  if (!local.within(high, begin, end) || end <= 0.0) return;
  begin = std::max(begin, 0.0);
  end = std::min(end, hit.t);
  double core_begin, core_end;
  if (local.within(low, core_begin, core_end) && core_begin > 0.0) end = std::min(end, core_begin + 1e-6);
  if (begin >= end) return;
  const double z0 = local.origin.z() + begin * local.direction.z(), z1 = local.origin.z() + end * local.direction.z();
  const double base = tank.options().base_elevation, spread = tank.datumBound().deviation;
  if (std::min(z0, z1) > base + spread + tank.options().height) return;
  if (std::max(z0, z1) < base - spread - kBelowDatum) return;
  const auto gap = [&](double t) {
    const TankPoint p = tank.at(local, t);
    const Face face = faceAt(tank, p, false);
    return Sample{p.rho - face.radius, p.rho_rate - face.along};
  };
  const double bend = radiusBend(tank, local, tank.bends(local, low), begin, end);
  const double t = firstRoot(gap, bend, begin, end);
  if (t >= hit.t) return;
  const TankPoint p = tank.at(local, t);
  if (onShell(tank, p.h)) hit = hitAt(tank, p, faceAt(tank, p, false), t, owner);
}

void traceInnerShell(const TankShape& tank, const TankRay& local, int owner, Hit& hit) {
  double begin, end, ignored;
  const double reach = tank.deviation() + 2.0 * tank.options().thickness;
  const double low = tank.options().radius - reach, high = tank.options().radius + reach;
  if (!local.within(low, ignored, begin) || !local.within(high, ignored, end)) return;
  begin = std::max(begin, 0.0);
  if (begin >= hit.t) return;
  const auto gap = [&](double t) {
    const TankPoint p = tank.at(local, t);
    const Face face = faceAt(tank, p, true);
    return Sample{face.radius - p.rho, face.along - p.rho_rate};
  };
  const RayBends bends = tank.bends(local, low);
  const double t = firstRoot(gap, radiusBend(tank, local, bends, begin, end) + bends.rho, begin, std::min(end, hit.t));
  if (t >= hit.t) return;
  const TankPoint p = tank.at(local, t);
  if (onShell(tank, p.h)) hit = hitAt(tank, p, faceAt(tank, p, true), t, owner);
}

namespace {

/// Points p with weight . (p - (0, 0, apex))^2 = constant between two elevations.
struct Quadric {
  Eigen::Vector3d weight;
  double apex, constant, z_low, z_high;
};

/// The nearest crossing before the hit, if there is one.
void traceQuadric(const TankShape& tank, const TankRay& ray, const Quadric& quadric, int owner, Hit& hit) {
  const Eigen::Vector3d& weight = quadric.weight;
  const Eigen::Vector3d o = ray.origin - Eigen::Vector3d(0.0, 0.0, quadric.apex);
  const double a = ray.direction.cwiseProduct(weight).dot(ray.direction), b = o.cwiseProduct(weight).dot(ray.direction);
  const double c = o.cwiseProduct(weight).dot(o) - quadric.constant, root = b * b - a * c;
  if (root < 0.0 || a == 0.0) return;
  const double wide = -(b + std::copysign(std::sqrt(root), b));
  for (const double t : {wide / a, wide == 0.0 ? kNever : c / wide}) {
    const double z = ray.origin.z() + t * ray.direction.z();
    if (!(t > 0.0 && t < hit.t) || z < quadric.z_low || z > quadric.z_high) continue;
    const Eigen::Vector3d normal = tank.worldNormal((o + t * ray.direction).cwiseProduct(weight));
    hit = {t, Surface::Roof, owner, 0, normal};
  }
}

}  // namespace

void traceRoof(const TankShape& tank, const TankRay& local, bool inside, int owner, Hit& hit) {
  const TankOptions& o = tank.options();
  const double eave = o.base_elevation + o.height, rise = o.roof_rise, radius = o.radius + tank.deviation();
  const double highest = std::max(local.origin.z(), local.origin.z() + hit.t * local.direction.z());
  if (o.roof == "none" || highest < (o.roof == "floating" ? o.base_elevation + o.roof_height : eave)) return;
  if (o.roof == "cone") {
    const double run = radius / rise;
    traceQuadric(tank, local, {{1.0, 1.0, -run * run}, eave + rise, 0.0, eave, eave + rise}, owner, hit);
  } else if (o.roof == "dome") {
    const double sphere = (radius * radius + rise * rise) / (2.0 * rise);
    traceQuadric(tank, local, {{1.0, 1.0, 1.0}, eave + rise - sphere, sphere * sphere, eave, kNever}, owner, hit);
  } else if (o.roof == "floating" && inside && local.direction.z() > 0.0) {
    const double t = (o.base_elevation + o.roof_height - local.origin.z()) / local.direction.z();
    if (t > 0.0 && t < hit.t && local.rho(t) < radius) hit = {t, Surface::Roof, owner, 0, Eigen::Vector3d::UnitZ()};
  }
}

}  // namespace tank_datum::synth
