#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "hit.h"

namespace tank_datum::synth {

/// A thing that hides what lies behind it.
struct Solid {
  enum class Kind { Box, Cylinder, Sphere };
  Kind kind = Kind::Box;
  int object = 0;                                      ///< index of the object it is part of
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< [m]
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: the box's own axes; a cylinder's is the third
  Eigen::Vector3d half = Eigen::Vector3d::Ones();      ///< half sizes; cylinder: radius, -, half length; sphere: radius

  Eigen::AlignedBox3d bounds() const;
  void trace(const Ray& ray, Hit& hit) const;
};

/// An upright ring of given thickness round a point: a bund wall.
struct RingWall {
  int object = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double inner = 1.0, outer = 1.3;  ///< radii [m]
  double bottom = -1.0, top = 1.0;  ///< elevations [m]

  void trace(const Ray& ray, Hit& hit) const;
};

/// Solids in a bounding volume hierarchy, split at the median.
class SolidTree {
 public:
  SolidTree() = default;
  explicit SolidTree(std::vector<Solid> solids);

  void trace(const Ray& ray, Hit& hit) const;

  /// Whether no solid's box comes within `margin` of the ray before `reach`.
  bool clear(const Ray& ray, double margin, double reach) const;

 private:
  struct Node {
    Eigen::AlignedBox3d box;
    std::uint32_t begin, end;  ///< of its solids
    std::uint32_t right;       ///< index of the right child; the left is the next node; 0 = leaf
  };

  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  /// Calls visit(node) for each leaf whose box, grown by `margin`, the ray meets before reach(); ends when it says so.
  template <class Reach, class Visit>
  void forLeaves(const Ray& ray, double margin, const Reach& reach, const Visit& visit) const;

  std::vector<Solid> solids_;
  std::vector<Node> nodes_;
};

}  // namespace tank_datum::synth
