#include "tank_datum/setups/setups.h"

#include <algorithm>
#include <cmath>

namespace tank_datum {

SetupSpread SetupAgreement::errorsOfOne() const {
  return adjusted() ? spread : SetupSpread{merged_sigma, 0.0, merged_sigma};
}

SetupSpread SetupAgreement::errorsOfPoints() const {
  SetupSpread error = errorsOfOne();
  for (const Setup& setup : setups) {
    if (setup.verdict != SetupVerdict::Bad) continue;
    const SetupMotion& off = setup.correction;
    error.height = std::max(error.height, std::abs(off.dz));
    error.tilt = std::max(error.tilt, std::hypot(off.tilt_x, off.tilt_y));
    error.plan = std::max(error.plan, std::hypot(off.dx, off.dy));
  }
  return error;
}

std::size_t SetupAgreement::seeing() const {
  return static_cast<std::size_t>(
      std::count_if(setups.begin(), setups.end(), [](const Setup& setup) { return setup.stations > 0; }));
}

double SetupAgreement::radiusError() const {
  return errorsOfOne().plan / std::sqrt(static_cast<double>(std::max<std::size_t>(1, seeing())));
}

Eigen::Vector3d SetupMotion::operator()(const Eigen::Vector3d& point, const Eigen::Vector3d& origin) const {
  const Eigen::Vector3d arm = point - origin;
  return point +
         Eigen::Vector3d(dx - tilt_x * arm.z(), dy - tilt_y * arm.z(), dz + tilt_x * arm.x() + tilt_y * arm.y());
}

const char* nameOf(BadSetups bad) {
  switch (bad) {
    case BadSetups::Free:
      return "free";
    case BadSetups::Drop:
      return "drop";
    case BadSetups::Keep:
      return "keep";
  }
  return "";
}

const char* nameOf(SetupVerdict verdict) {
  switch (verdict) {
    case SetupVerdict::Single:
      return "single";
    case SetupVerdict::Unseen:
      return "unseen";
    case SetupVerdict::Alone:
      return "alone";
    case SetupVerdict::Agrees:
      return "agrees";
    case SetupVerdict::Adjusted:
      return "adjusted";
    case SetupVerdict::Bad:
      return "bad";
    case SetupVerdict::Duplicate:
      return "duplicate";
  }
  return "";
}

}  // namespace tank_datum
