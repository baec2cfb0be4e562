#pragma once

#include <Eigen/Core>

#include "root.h"

namespace tank_datum::synth {

enum class Surface {
  None,
  Shell,
  Roof,
  Ring,
  Weld,
  Pad,
  Shoulder,
  AnnularPlate,
  Ringwall,
  Crown,
  Slab,
  Soil,
  Floor,
  Ground,
  Object
};

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< unit length, so t is metres
};

/// The nearest thing a ray has met so far.
struct Hit {
  double t = kNever;
  Surface surface = Surface::None;
  int owner = -1;                                    ///< index of the tank or object
  int part = 0;                                      ///< tells the patches of one owner apart
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the surface without its roughness, any sign, unit length

  bool found() const { return surface != Surface::None; }
  bool samePlace(const Hit& other) const {
    return surface == other.surface && owner == other.owner && part == other.part;
  }
};

}  // namespace tank_datum::synth
