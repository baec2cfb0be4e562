#include "foot_frame.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/portable_math.h"
#include "locate/foot_unit.h"

namespace tank_datum {
namespace {

void scale(Circle& circle, double factor) {
  circle.center *= factor;
  circle.radius *= factor;
}

void scaleLengths(Station& s, double factor) {
  for (double* length : {&s.sigma_z, &s.radius, &s.sigma_radius}) *length *= factor;
}

void scale(FootProfile& profile, double factor) {
  for (auto* lengths : {&profile.height, &profile.spread, &profile.error}) {
    for (double& length : *lengths) length *= factor;
  }
  for (double* length : {&profile.bin, &profile.band_from, &profile.band_to, &profile.edge, &profile.blur,
                         &profile.unseen, &profile.offset, &profile.misfit, &profile.noise}) {
    *length *= factor;
  }
}

void scale(StationProfile& section, double factor) {
  for (SectionPoint& p : section.points) p.d *= static_cast<float>(factor), p.z *= static_cast<float>(factor);
  for (double* length : {&section.base, &section.foundation, &section.noise, &section.shell_noise}) *length *= factor;
}

}  // namespace

DatumOptions inUnits(DatumOptions options, double unit) {
  options.crop.reach *= unit;
  options.shell.step *= unit;
  options.shell.half_band *= unit;
  options.shell.reach *= unit;
  for (double& height : options.shell.heights) height *= unit;
  return options;
}

Eigen::Matrix3d uprightTurn(const ShellLean& lean) {
  return Eigen::Quaterniond::FromTwoVectors(lean.axis(), Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

Scan turnedUpright(const Scan& scan, const Datum& datum) {
  const Eigen::Vector2d& center = datum.tank.circle.center;
  const Eigen::Vector3d foot(center.x(), center.y(), datum.tank.foot.coefficients[0]);
  return scan.turnedAbout(foot + datum.origin, uprightTurn(datum.lean));
}

Tank onItsFoot(Tank tank, const ShellEvidence& evidence) {
  if (evidence.known() && FootFrame(tank, evidence.lean).isTurned()) tank.circle = evidence.at_foot;
  return tank;
}

FootFrame::FootFrame(const Tank& tank, const ShellLean& lean) : unit_(footUnit(tank.circle.radius, tank.resolution)) {
  constexpr double kUpright =
      0.0044;                    // a quarter of a degree: up to there the stages follow the shell's own line [m/m]
  constexpr double kSure = 4.0;  // standard errors
  const Eigen::Vector2d& center = tank.circle.center;
  foot_ = {center.x(), center.y(), tank.foot.coefficients[0]};
  if (!lean.known() || lean.slope.norm() < std::max(kUpright, kSure * lean.sigma)) return;
  turned_ = true;
  slope_ = lean.slope;
  turn_ = uprightTurn(lean);
}

Ring FootFrame::into(Ring ring) const {
  for (auto* points : {&ring.points, &ring.search}) {
    for (Eigen::Vector3d& p : *points) p = in(p);
  }
  ring.reach /= unit_;
  ring.rounding /= unit_;
  return ring;
}

Tank FootFrame::into(Tank tank) const {
  if (turned_) tank.foot.coefficients.segment<2>(1) += tank.circle.radius * slope_;
  scale(tank.circle, 1.0 / unit_);
  tank.foot.coefficients /= unit_;
  tank.foot.covariance /= unit_ * unit_;
  tank.foot.sigma /= unit_;
  for (double* length : {&tank.rms, &tank.height, &tank.resolution, &tank.behind}) *length /= unit_;
  return tank;
}

void FootFrame::turnBack(Station& s, const Circle& circle) const {
  const double above = s.z_paper - s.z;
  const Eigen::Vector2d outwards(portable::cos(s.direction), portable::sin(s.direction));
  const Eigen::Vector2d on_circle = (circle.center + circle.radius * outwards) / unit_;
  s.z_refused = out({on_circle.x(), on_circle.y(), s.z_refused}).z();
  const Eigen::Vector3d point = out({s.x, s.y, s.z});
  scaleLengths(s, unit_);
  s.x = point.x();
  s.y = point.y();
  s.z = point.z();
  s.z_paper = s.z + above * unit_;
  if (turned_) s.radius = (point.head<2>() - circle.center).norm();
}

void FootFrame::backFrom(FootResult& foot) const {
  for (Circle* circle : {&foot.circle, &foot.refined.circle}) scale(*circle, unit_);
  for (Eigen::Index i = 0; i < foot.curve.control_points.rows(); ++i) {
    foot.curve.control_points.row(i) = out(foot.curve.control_points.row(i).transpose()).transpose();
  }
  foot.curve.rms *= unit_;
  foot.curve.max_residual *= unit_;
  foot.refined.sigma_radius *= unit_;
  foot.refined.rounding *= unit_;
  foot.refined.narrow_lip *= unit_;
  foot.refined.maybe_pipe *= unit_;
  foot.refined.shell_from *= unit_;
  scale(foot.refined.profile, unit_);
  for (std::size_t i = 0; i < foot.stations.size(); ++i) {
    const double before = foot.stations[i].z * unit_;
    turnBack(foot.stations[i], foot.circle);
    if (i >= foot.refined.sections.size()) continue;
    scale(foot.refined.sections[i], unit_);
    const double risen = foot.stations[i].z - before;
    if (std::isfinite(risen)) foot.refined.sections[i].base += risen;
  }
}

}  // namespace tank_datum
