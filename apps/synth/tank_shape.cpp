#include "tank_shape.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "tank_curves.h"
#include "value_noise.h"

namespace tank_datum::synth {
namespace {

constexpr int kNodeCount = 32768;  // cubic Hermite error: 3e-12 m for 60 waves of 50 mm, 3e-10 m for 200

/// Stands for the azimuth in table look-ups: 0 .. 4 round the circle, monotone, without trigonometry.
double diamondAngle(double x, double y) {
  const double p = y / (std::abs(x) + std::abs(y));
  return x >= 0.0 ? 1.0 + p : 3.0 - p;
}

/// Its derivative by azimuth at unit distance from the centre is 1 / this^2.
double diamondSize(double x, double y) { return std::abs(x) + std::abs(y); }

/// Two courses meet in a taper this much longer than their step, as welds do.
double taper(double step) { return 4.0 * std::abs(step); }

}  // namespace

bool TankRay::within(double radius, double& begin, double& end) const {
  if (a <= 0.0) {
    begin = -kNever, end = kNever;
    return c <= radius * radius;
  }
  const double root = b * b - a * (c - radius * radius);
  if (root < 0.0) return false;
  begin = (-b - std::sqrt(root)) / a;
  end = (-b + std::sqrt(root)) / a;
  return true;
}

TankShape::TankShape(const TankOptions& options, std::uint64_t seed)
    : options_(options),
      outer_stepped_(options.course_step != 0.0 && options.course_flush == "inner"),
      inner_stepped_(options.course_step != 0.0 && options.course_flush == "outer"),
      tilt_slope_(synth::tiltSlope(options)),
      lean_x_(options.lean_x),
      lean_y_(options.lean_y) {
  if (options.lean_with_tilt) {  // the axis is square to the base to first order: it falls away from the high side
    lean_x_ -= tilt_slope_ * portable::cos(options.tilt_direction);
    lean_y_ -= tilt_slope_ * portable::sin(options.tilt_direction);
  }
  tabulate(seed);
}

void TankShape::tabulate(std::uint64_t seed) {
  const auto shell = shellHarmonics(options_, seed), lip = lipHarmonics(options_, seed);
  const double level[kCurves] = {options_.base_elevation, options_.radius, 0.0, 0.0, 0.0, 0.0};
  double azimuth = -kPi / 2.0, rate[kCurves] = {};
  nodes_.resize(kNodeCount + 1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double place = 4.0 * static_cast<double>(i) / kNodeCount;
    const double y = place <= 2.0 ? place - 1.0 : 3.0 - place, x = std::copysign(1.0 - std::abs(y), 2.0 - place);
    const double before = azimuth, size = diamondSize(x, y) / std::hypot(x, y);
    azimuth = before + std::remainder(portable::atan2(y, x) - before, 2.0 * kPi);
    const Curve curves[kCurves] = {datumCurve(options_, azimuth),       harmonicCurve(shell, azimuth, false),
                                   harmonicCurve(shell, azimuth, true), harmonicCurve(lip, azimuth, false),
                                   plateSlopeCurve(options_, azimuth),  sectorCurve(options_, azimuth)};
    for (int k = 0; k < kCurves; ++k) {
      const double above_level = k == 0 ? curves[k].value - level[k] : curves[k].value;
      nodes_[i].value[k] = level[k] + above_level;
      nodes_[i].rate[k] = curves[k].rate * size * size;
      bounds_[k].deviation = std::max(bounds_[k].deviation, 1.001 * std::abs(above_level));
      bounds_[k].slope = std::max(bounds_[k].slope, 1.01 * std::abs(curves[k].rate));
      if (i > 0)
        bounds_[k].bend = std::max(bounds_[k].bend, 1.05 * std::abs(curves[k].rate - rate[k]) / (azimuth - before));
      rate[k] = curves[k].rate;
    }
  }
  plain_ = bounds_[4].deviation == 0.0 && bounds_[5].deviation == 0.0;
  const double courses = std::floor(options_.height / options_.course_height) * std::abs(options_.course_step);
  deviation_ = bounds_[1].deviation + 1.2 * bounds_[2].deviation + courses + 1e-3;
}

Section TankShape::section(double x, double y) const {
  constexpr double step = 4.0 / kNodeCount;
  const double place = diamondAngle(x, y) / step;
  const auto i = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kNodeCount - 1));
  const double u = place - static_cast<double>(i), v = 1.0 - u, size = diamondSize(x, y);
  const double turn = (x * x + y * y) / (size * size);  // from derivatives by place to those by azimuth
  const double w1 = u * u * (3.0 - 2.0 * u), s0 = u * v * v * step, s1 = -u * u * v * step;
  const double dw = 6.0 * u * v / step * turn, d0 = v * (1.0 - 3.0 * u) * turn, d1 = u * (3.0 * u - 2.0) * turn;
  const Node &a = nodes_[i], &b = nodes_[i + 1];
  const auto value = [&](int k) {
    return a.value[k] + w1 * (b.value[k] - a.value[k]) + s0 * a.rate[k] + s1 * b.rate[k];
  };
  const auto rate = [&](int k) { return dw * (b.value[k] - a.value[k]) + d0 * a.rate[k] + d1 * b.rate[k]; };
  Section section{value(0), rate(0), value(1), rate(1), value(2), rate(2), value(3), rate(3), 0.0, 0.0, 0.0, 0.0};
  if (plain_) return section;
  section.slope = value(4), section.slope_rate = rate(4);
  section.rise = value(5), section.rise_rate = rate(5);
  return section;
}

double TankShape::courseOffset(double h) const {
  if (options_.course_step == 0.0 || h < 0.5 * options_.course_height) return 0.0;
  const double nearest = std::round(h / options_.course_height);
  const double t = 0.5 + (h - nearest * options_.course_height) / taper(options_.course_step);
  return -options_.course_step * (nearest - 1.0 + Fade(std::clamp(t, 0.0, 1.0)).value);
}

double TankShape::courseRate(double h) const {
  if (options_.course_step == 0.0 || h < 0.5 * options_.course_height) return 0.0;
  const double length = taper(options_.course_step);
  const double t = 0.5 + (h - std::round(h / options_.course_height) * options_.course_height) / length;
  return t <= 0.0 || t >= 1.0 ? 0.0 : -options_.course_step * Fade(t).rate / length;
}

double TankShape::courseBend(double h_low, double h_high) const {
  if (options_.course_step == 0.0) return 0.0;
  const double length = taper(options_.course_step);
  const double seam = std::max(1.0, std::ceil((h_low - length) / options_.course_height)) * options_.course_height;
  return seam > h_high + length ? 0.0 : std::abs(options_.course_step) * Fade::kMaxBend / (length * length);
}

double TankShape::outerRadius(const Section& s, double h) const {
  const double courses = outer_stepped_ ? courseOffset(h) : 0.0;
  return s.foot + s.growth * h / options_.height + courses;
}

double TankShape::innerRadius(const Section& s, double h) const {
  const double courses = inner_stepped_ ? -courseOffset(h) : 0.0;
  return s.foot - options_.thickness + s.growth * h / options_.height + courses;
}

Eigen::Vector3d TankShape::toTank(const Eigen::Vector3d& world) const {
  const double up = world.z() - options_.base_elevation;
  return {world.x() - options_.x - lean_x_ * up, world.y() - options_.y - lean_y_ * up, world.z()};
}

Eigen::Vector3d TankShape::toWorld(const Eigen::Vector3d& local) const {
  const double up = local.z() - options_.base_elevation;
  return {local.x() + options_.x + lean_x_ * up, local.y() + options_.y + lean_y_ * up, local.z()};
}

Eigen::Vector3d TankShape::worldNormal(const Eigen::Vector3d& g) const {
  return Eigen::Vector3d(g.x(), g.y(), g.z() - lean_x_ * g.x() - lean_y_ * g.y()).normalized();
}

TankRay TankShape::local(const Ray& ray) const {
  TankRay r;
  r.origin = toTank(ray.origin);
  const Eigen::Vector3d& d = ray.direction;
  r.direction = {d.x() - lean_x_ * d.z(), d.y() - lean_y_ * d.z(), d.z()};
  r.a = r.direction.head<2>().squaredNorm();
  r.b = r.origin.head<2>().dot(r.direction.head<2>());
  r.c = r.origin.head<2>().squaredNorm();
  r.moment = r.origin.x() * r.direction.y() - r.origin.y() * r.direction.x();
  return r;
}

TankPoint TankShape::at(const TankRay& ray, double t) const {
  TankPoint p;
  p.position = ray.origin + t * ray.direction;
  p.rho = std::sqrt(p.position.x() * p.position.x() + p.position.y() * p.position.y());
  p.rho_rate = (ray.b + ray.a * t) / p.rho;
  p.azimuth_rate = ray.moment / (p.rho * p.rho);
  p.section = section(p.position.x(), p.position.y());
  p.h = p.position.z() - p.section.datum;
  p.h_rate = ray.direction.z() - p.section.datum_rate * p.azimuth_rate;
  return p;
}

RayBends TankShape::bends(const TankRay& ray, double least_rho) const {
  // azimuth' = moment / rho^2, azimuth'' = -2 moment rho' / rho^3, rho'' = moment^2 / rho^3
  const double moment = std::abs(ray.moment), first = moment / (least_rho * least_rho);
  const double second = 2.0 * moment * std::sqrt(ray.a) / (least_rho * least_rho * least_rho);
  const auto along = [&](const Bound& bound) { return bound.bend * first * first + bound.slope * second; };
  return {along(bounds_[0]),
          along(bounds_[1]),
          along(bounds_[2]),
          along(bounds_[3]),
          along(bounds_[4]),
          along(bounds_[5]),
          moment * moment / (least_rho * least_rho * least_rho),
          first,
          std::abs(ray.direction.z()) + bounds_[0].slope * first};
}

}  // namespace tank_datum::synth
