#include "solids.h"

#include <algorithm>
#include <cmath>

namespace tank_datum::synth {
namespace {

/// Where the ray is inside |p| <= half along every axis given; the axis by which it enters and leaves.
struct SlabSpan {
  double begin = -kNever, end = kNever;
  int enter_axis = 0, leave_axis = 0;
};

SlabSpan slabs(const Eigen::Vector3d& o, const Eigen::Vector3d& d, const Eigen::Vector3d& half, int first_axis) {
  SlabSpan span;
  for (int k = first_axis; k < 3; ++k) {
    if (d[k] == 0.0) {
      if (std::abs(o[k]) > half[k]) span.end = -kNever;
      continue;
    }
    const double one = (-half[k] - o[k]) / d[k], other = (half[k] - o[k]) / d[k];
    if (std::min(one, other) > span.begin) span.begin = std::min(one, other), span.enter_axis = k;
    if (std::max(one, other) < span.end) span.end = std::max(one, other), span.leave_axis = k;
  }
  return span;
}

void record(double t, int object, const Eigen::Vector3d& normal, Hit& hit) {
  if (t > 0.0 && t < hit.t) hit = {t, Surface::Object, object, 0, normal};
}

}  // namespace

Eigen::AlignedBox3d Solid::bounds() const {
  Eigen::Vector3d reach = Eigen::Vector3d::Constant(half.x());
  if (kind == Kind::Box) reach = axes.cwiseAbs() * half;
  if (kind == Kind::Cylinder) reach = axes.cwiseAbs() * Eigen::Vector3d(half.x(), half.x(), half.z());
  return {centre - reach, centre + reach};
}

void Solid::trace(const Ray& ray, Hit& hit) const {
  const Eigen::Vector3d o = axes.transpose() * (ray.origin - centre), d = axes.transpose() * ray.direction;
  if (kind == Kind::Box) {
    const SlabSpan span = slabs(o, d, half, 0);
    if (span.begin <= span.end) record(span.begin, object, axes.col(span.enter_axis), hit);
    return;
  }
  const int dimensions = kind == Kind::Sphere ? 3 : 2;
  const double a = d.head(dimensions).squaredNorm(), b = o.head(dimensions).dot(d.head(dimensions));
  const double root = b * b - a * (o.head(dimensions).squaredNorm() - half.x() * half.x());
  if (root < 0.0) return;
  double begin = a > 0.0 ? (-b - std::sqrt(root)) / a : -kNever;
  const double end = a > 0.0 ? (-b + std::sqrt(root)) / a : kNever;
  Eigen::Vector3d normal = o + begin * d;
  if (kind == Kind::Cylinder) {
    normal.z() = 0.0;
    const SlabSpan caps = slabs(o, d, half, 2);
    if (caps.begin > end || caps.end < begin) return;
    if (caps.begin > begin) begin = caps.begin, normal = Eigen::Vector3d::UnitZ();
  }
  record(begin, object, axes * normal.normalized(), hit);
}

void RingWall::trace(const Ray& ray, Hit& hit) const {
  const Eigen::Vector2d o = ray.origin.head<2>() - centre, d = ray.direction.head<2>();
  const auto tryAt = [&](double t, const Eigen::Vector3d& normal, double low_rho, double high_rho) {
    const double z = ray.origin.z() + t * ray.direction.z(), rho = (o + t * d).norm();
    if (z >= bottom && z <= top + 1e-9 && rho >= low_rho - 1e-9 && rho <= high_rho + 1e-9)
      record(t, object, normal, hit);
  };
  const double a = d.squaredNorm(), b = o.dot(d);
  for (const double radius : {inner, outer}) {
    const double root = b * b - a * (o.squaredNorm() - radius * radius);
    if (root < 0.0 || a == 0.0) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(root)) / a;
      const Eigen::Vector2d out = (o + t * d).normalized();
      tryAt(t, {out.x(), out.y(), 0.0}, inner, outer);
    }
  }
  if (ray.direction.z() != 0.0)
    tryAt((top - ray.origin.z()) / ray.direction.z(), Eigen::Vector3d::UnitZ(), inner, outer);
}

SolidTree::SolidTree(std::vector<Solid> solids) : solids_(std::move(solids)) {
  if (!solids_.empty()) build(0, static_cast<std::uint32_t>(solids_.size()));
}

std::uint32_t SolidTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({Eigen::AlignedBox3d(), begin, end, 0});
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = begin; i < end; ++i) box.extend(solids_[i].bounds());
  nodes_[index].box = box;
  if (end - begin <= 2) return index;
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(solids_.begin() + begin, solids_.begin() + middle, solids_.begin() + end,
                   [axis](const Solid& a, const Solid& b) { return a.centre[axis] < b.centre[axis]; });
  build(begin, middle);
  nodes_[index].right = build(middle, end);
  return index;
}

template <class Reach, class Visit>
void SolidTree::forLeaves(const Ray& ray, double margin, const Reach& reach, const Visit& visit) const {
  if (nodes_.empty()) return;
  std::uint32_t waiting[64], depth = 0;
  waiting[depth++] = 0;
  const Eigen::Array3d inverse = ray.direction.array().inverse();
  while (depth > 0) {
    const std::uint32_t index = waiting[--depth];
    const Node& node = nodes_[index];
    const Eigen::Array3d low = ((node.box.min() - ray.origin).array() - margin) * inverse;
    const Eigen::Array3d high = ((node.box.max() - ray.origin).array() + margin) * inverse;
    const double begin = low.min(high).maxCoeff(), end = low.max(high).minCoeff();
    if (begin > end || end < 0.0 || begin > reach()) continue;
    if (node.right == 0) {
      if (visit(node)) return;
    } else {
      waiting[depth++] = node.right;
      waiting[depth++] = index + 1;
    }
  }
}

void SolidTree::trace(const Ray& ray, Hit& hit) const {
  forLeaves(
      ray, 0.0, [&] { return hit.t; },
      [&](const Node& leaf) {
        for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) solids_[i].trace(ray, hit);
        return false;
      });
}

bool SolidTree::clear(const Ray& ray, double margin, double reach) const {
  bool met = false;
  forLeaves(
      ray, margin, [&] { return reach; }, [&](const Node&) { return met = true; });
  return !met;
}

}  // namespace tank_datum::synth
