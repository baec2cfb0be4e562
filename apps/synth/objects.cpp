#include "objects.h"

#include "core/portable_math.h"
#include "random.h"
#include "rotation.h"

namespace tank_datum::synth {
namespace {

constexpr double kSunk = 0.3;  ///< what stands on the ground reaches this far into it [m]

Eigen::Matrix3d turned(double yaw) { return rotation(yaw, Eigen::Vector3d::UnitZ()); }

/// Axes with the third, a cylinder's, along the yaw.
Eigen::Matrix3d lying(double yaw) { return turned(yaw) * rotation(kPi / 2.0, Eigen::Vector3d::UnitY()); }

/// Puts the parts of one object together.
class Maker {
 public:
  Maker(const ObjectOptions& options, int index, const Tank& tank, const Ground& ground, std::uint64_t seed)
      : o_(options), index_(index), tank_(tank), ground_(ground), seed_(seed) {
    const TankOptions& t = tank.shape.options();
    const double reach = t.radius + o_.gap;
    x_ = o_.place == "world" ? o_.x : t.x + reach * portable::cos(o_.azimuth);
    y_ = o_.place == "world" ? o_.y : t.y + reach * portable::sin(o_.azimuth);
    yaw_ = o_.yaw + (o_.place == "world" ? 0.0 : o_.azimuth);
    base_ = ground.elevation(x_, y_) + o_.z;
  }

  void make(Things& things) {
    if (o_.kind == "box") standing(things, {x_, y_}, {o_.length, o_.width});
    if (o_.kind == "pipe_vertical") pipe(things, Eigen::Matrix3d::Identity(), base_ - kSunk, o_.height + kSunk);
    if (o_.kind == "pipe_parallel") pipe(things, lying(yaw_ + kPi / 2.0), base_, o_.length);
    if (o_.kind == "pipe_radial") pipe(things, lying(yaw_), base_, o_.length);
    if (o_.kind == "nozzle") nozzle(things);
    if (o_.kind == "stairs") stairs(things);
    if (o_.kind == "tree") tree(things);
    if (o_.kind == "bund") {
      const double outer = o_.radius + o_.thickness;
      things.ring_walls.push_back({index_, {x_, y_}, o_.radius, outer, base_ - 5.0, base_ + o_.height});
    }
    if (o_.kind == "bund_rectangle") bundRectangle(things);
  }

 private:
  void add(Things& things, Solid::Kind kind, const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes,
           const Eigen::Vector3d& half) {
    things.solids.push_back({kind, index_, centre, axes, half});
  }

  void standing(Things& things, const Eigen::Vector2d& at, const Eigen::Vector2d& size, double depth = kSunk) {
    const double tall = o_.height + (o_.z > 0.0 ? 0.0 : depth);
    add(things, Solid::Kind::Box, {at.x(), at.y(), base_ + o_.height - tall / 2.0}, turned(yaw_),
        {size.x() / 2, size.y() / 2, tall / 2});
  }

  /// `z` is the lower end of an upright pipe, the axis of a lying one; a radial pipe begins at its place.
  void pipe(Things& things, const Eigen::Matrix3d& axes, double z, double length) {
    Eigen::Vector3d centre(x_, y_, z);
    if (o_.kind != "pipe_parallel") centre += axes.col(2) * (length / 2.0);
    add(things, Solid::Kind::Cylinder, centre, axes, {o_.radius, o_.radius, length / 2.0});
  }

  void nozzle(Things& things) {
    const TankShape& shape = tank_.shape;
    const Section s = shape.section(portable::cos(o_.azimuth), portable::sin(o_.azimuth));
    const Eigen::Vector3d out(portable::cos(o_.azimuth), portable::sin(o_.azimuth), 0.0);
    const Eigen::Vector3d foot = shape.toWorld(out * s.foot + Eigen::Vector3d(0.0, 0.0, s.datum + o_.z));
    const double from = -0.2, flange = 0.02;  // begins behind the shell
    const Eigen::Matrix3d axes = lying(o_.azimuth);
    add(things, Solid::Kind::Cylinder, foot + out * (from + o_.length) / 2.0, axes,
        {o_.radius, o_.radius, (o_.length - from) / 2.0});
    add(things, Solid::Kind::Cylinder, foot + out * o_.length, axes, {1.6 * o_.radius, 1.6 * o_.radius, flange});
  }

  /// A spiral of treads from the ground to the top of the shell, `gap` from it, `width` wide.
  void stairs(Things& things) {
    constexpr double kRise = 0.2, kRun = 0.25, kThickness = 0.04;
    const TankOptions& t = tank_.shape.options();
    const double radius = t.radius + o_.gap + o_.width / 2.0, start = ground_.elevation(x_, y_);
    for (int i = 1; start + i * kRise < t.base_elevation + t.height; ++i) {
      const double azimuth = o_.azimuth + i * kRun / radius;
      const Eigen::Vector3d centre(t.x + radius * portable::cos(azimuth), t.y + radius * portable::sin(azimuth),
                                   start + i * kRise);
      add(things, Solid::Kind::Box, centre, turned(azimuth), {o_.width / 2.0, kRun / 2.0 + 0.01, kThickness / 2.0});
    }
  }

  /// A stem of `radius` and `height`, leaves in a ball `width` wide round its top.
  void tree(Things& things) {
    pipe(things, Eigen::Matrix3d::Identity(), base_ - kSunk, o_.height + kSunk);
    Random random({seed_, 401, static_cast<std::uint64_t>(index_)});
    const Eigen::Vector3d top(x_, y_, base_ + o_.height);
    for (int i = 0; i < o_.count; ++i) {
      const Eigen::Vector3d way = Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian()).normalized();
      const double from_top = o_.width / 2.0 * portable::cbrt(random.uniform()), size = random.uniform(0.03, 0.12);
      add(things, Solid::Kind::Sphere, top + way * from_top, Eigen::Matrix3d::Identity(), {size, size, size});
    }
  }

  /// Four walls, `length` x `width` inside.
  void bundRectangle(Things& things) {
    const Eigen::Matrix3d axes = turned(yaw_);
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d along = axes.col(0) * (side * (o_.length + o_.thickness) / 2.0);
      const Eigen::Vector3d across = axes.col(1) * (side * (o_.width + o_.thickness) / 2.0);
      standing(things, {x_ + along.x(), y_ + along.y()}, {o_.thickness, o_.width + 2.0 * o_.thickness}, 5.0);
      standing(things, {x_ + across.x(), y_ + across.y()}, {o_.length, o_.thickness}, 5.0);
    }
  }

  const ObjectOptions& o_;
  int index_;
  const Tank& tank_;
  const Ground& ground_;
  std::uint64_t seed_;
  double x_, y_, yaw_, base_;
};

}  // namespace

std::vector<ObjectOptions> allObjects(const SceneOptions& scene) {
  std::vector<ObjectOptions> all = scene.objects;
  Random random({scene.seed, 402});
  const Clutter& c = scene.clutter;
  for (int i = 0; i < c.boxes + c.pipes; ++i) {
    ObjectOptions o;
    o.azimuth = random.uniform(0.0, 2.0 * kPi);
    o.gap = random.uniform(c.min_gap, c.max_gap);
    o.yaw = random.uniform(0.0, 2.0 * kPi);
    o.length = random.uniform(0.2, 1.2);
    o.width = random.uniform(0.2, 1.0);
    o.height = random.uniform(0.2, 1.5);
    if (i >= c.boxes) {
      const char* kinds[] = {"pipe_vertical", "pipe_parallel", "pipe_radial"};
      o.kind = kinds[(i - c.boxes) % 3];
      o.yaw = 0.0;
      o.radius = random.uniform(0.03, 0.15);
      o.z = o.kind == "pipe_vertical" ? 0.0 : random.uniform(0.2, 0.8);
      o.length = o.kind == "pipe_radial" ? random.uniform(1.0, 4.0) : random.uniform(2.0, 10.0);
      o.height = random.uniform(1.0, 6.0);
    }
    all.push_back(o);
  }
  return all;
}

Things makeThings(const SceneOptions& scene, const Ground& ground, const Tanks& tanks) {
  Things things;
  int index = 0;
  for (const ObjectOptions& object : allObjects(scene)) {
    Maker(object, index, *tanks[static_cast<std::size_t>(object.tank)], ground, scene.seed).make(things);
    ++index;
  }
  return things;
}

}  // namespace tank_datum::synth
