#pragma once

#include <Eigen/Core>
#include <vector>

#include "setups/arc_comparison.h"
#include "setups/setup_groups.h"
#include "tank_datum/setups/setups.h"

namespace tank_datum {

/// What one arc says of the setups that see it.
struct ArcView {
  std::size_t number = 0;  ///< round the ring
  bool shell = false;      ///< radii of the shell, else elevations of the foundation
  double azimuth = 0.0;    ///< of its middle [rad]
  ArcOffsets seen;         ///< of the points as they were given
  Eigen::MatrixXd motion;  ///< [k x 5] what the parameters of each setup's error do to its offset here
};

/// The errors of all setups, five parameters each in the order of SetupMotion, as far as the overlaps and the priors
/// tell them.
struct SetupAdjustment {
  Eigen::VectorXd errors;
  Eigen::MatrixXd covariance;
  SetupSpread spread;
  bool height_estimated = false, tilt_estimated = false, plan_estimated = false;
  std::vector<bool> bad;
  std::vector<bool> freed;                    ///< bad ones that were adjusted without priors
  std::vector<double> rms_before, rms_after;  ///< of each setup's foundation against the others', NaN without any [m]
  double all_before = kUnknown, all_after = kUnknown;
  SetupGroups groups;

  SetupMotion errorOf(std::size_t setup) const {
    const auto at = static_cast<Eigen::Index>(setup) * SetupMotion::kParameters;
    return SetupMotion::of(errors.segment<SetupMotion::kParameters>(at));
  }
};

/// Least squares of the differences in the overlaps with priors on every parameter (Bayes), so that the common part of
/// all setups, which no overlap sees, is zero and stays in the covariance.
///
/// The priors' sigmas are those of the options, or variance components: restricted maximum likelihood by the fixed
/// point of Harville 1977 (sigma^2 = x'x / effective number), with a weak log-normal prior about 2 mm, 10 arc-seconds
/// and 2 mm, or for heights about what places are seen to err by, where that is more. Where no more than three of the
/// parameters are determined these figures are taken, wider by what they are uncertain themselves (assumedSigma()).
/// Offsets of an arc have an error of their own on top of that of their points, from the residuals (median of the
/// squares). Bad setups are named, and adjusted without priors where few others leave no doubt (badSetups()). Where the
/// others' heights are of two groups (twoGroups()), half of what these differ by is in the common part's variance.
SetupAdjustment adjustSetups(const std::vector<ArcView>& arcs, std::size_t setups, const SetupOptions& options);

}  // namespace tank_datum
