#include "tank.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"

namespace tank_datum::synth {

bool Tank::contains(const Eigen::Vector3d& world) const {
  const Eigen::Vector3d p = shape.toTank(world);
  const Section s = shape.section(p.x(), p.y());
  const double h = p.z() - s.datum;
  return h < shape.options().height && std::hypot(p.x(), p.y()) < shape.innerRadius(s, h);
}

void Tank::trace(const Ray& ray, bool inside, Hit& hit) const {
  const TankRay local = shape.local(ray);
  if (inside) {
    floor.trace(local, index_, hit);
    traceInnerShell(shape, local, index_, hit);
  } else {
    traceShell(shape, local, index_, hit);
    foundation.trace(local, index_, hit);
  }
  traceRoof(shape, local, inside, index_, hit);
}

double Tank::firstPossible(const Ray& ray, double margin) const {
  double begin, end;
  const double reach = margin + shape.options().radius + shape.deviation() + foundation.width() + shape.lipBound();
  return shape.local(ray).within(reach, begin, end) && end > 0.0 ? begin : kNever;
}

bool Tank::plainShell(const Ray& ray, double t, double margin) const {
  const TankOptions& o = shape.options();
  const Eigen::Vector3d place = ray.origin + t * ray.direction;
  const double h = fromDatum(place, false).y(), spread = shape.datumBound().deviation;
  double lowest = o.foundation.weld + foundation.noise().bound();
  for (const Heap& heap : foundation.heaps()) lowest = std::max(lowest, heap.options.depth + heap.noise.bound());
  if (h < lowest + margin || h > o.height - margin) return false;
  const double top = std::max(ray.origin.z(), place.z()) + margin - o.base_elevation + spread;
  return std::all_of(o.rings.begin(), o.rings.end(), [&](const Ring& r) { return top < r.height - r.thickness; });
}

Eigen::Vector3d Tank::shellPoint(double azimuth, double height, bool inside) const {
  const TankOptions& o = shape.options();
  double own = azimuth;  // in the sheared frame; tilt moves it by some 1e-5 rad, a lean by its offset over the radius
  Eigen::Vector3d world;
  for (int i = 0; i < 20; ++i) {
    const Section s = shape.section(portable::cos(own), portable::sin(own));
    const double radius = inside ? shape.innerRadius(s, height) : shape.outerRadius(s, height);
    world = shape.toWorld({radius * portable::cos(own), radius * portable::sin(own), s.datum + height});
    own += std::remainder(azimuth - portable::atan2(world.y() - o.y, world.x() - o.x), 2.0 * kPi);
  }
  return world;
}

Eigen::Vector2d Tank::fromDatum(const Eigen::Vector3d& world, bool inside) const {
  const Eigen::Vector3d p = shape.toTank(world);
  const Section s = shape.section(p.x(), p.y());
  return {std::hypot(p.x(), p.y()) - shape.footRadius(s, inside), p.z() - s.datum};
}

}  // namespace tank_datum::synth
