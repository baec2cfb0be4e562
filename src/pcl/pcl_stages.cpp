#include "tank_datum/pcl/pcl_stages.h"

namespace tank_datum {

Tank movedBy(const Eigen::Vector3d& shift, const Tank& tank) {
  Tank moved = tank;
  moved.circle.center += shift.head<2>();
  if (moved.foot.valid()) moved.foot.coefficients[0] += shift.z();
  return moved;
}

}  // namespace tank_datum
