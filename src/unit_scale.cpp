#include "unit_scale.h"

namespace tank_datum {
namespace {

void scale(Circle& circle, double factor) {
  circle.center *= factor;
  circle.radius *= factor;
}

void scale(Points& points, double factor) {
  for (Eigen::Vector3d& p : points) p *= factor;
}

void scale(Station& s, double factor) {
  for (double* length : {&s.x, &s.y, &s.z, &s.sigma_z, &s.radius, &s.sigma_radius, &s.z_paper}) *length *= factor;
}

void scale(FootProfile& profile, double factor) {
  for (auto* lengths : {&profile.height, &profile.spread, &profile.error}) {
    for (double& length : *lengths) length *= factor;
  }
  for (double* length : {&profile.bin, &profile.band_from, &profile.band_to, &profile.edge, &profile.blur,
                         &profile.offset, &profile.misfit, &profile.noise}) {
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

Tank inUnits(Tank tank, double unit) {
  scale(tank.circle, 1.0 / unit);
  tank.foot.coefficients /= unit;
  tank.foot.covariance /= unit * unit;
  tank.foot.sigma /= unit;
  for (double* length : {&tank.rms, &tank.height, &tank.resolution, &tank.behind}) *length /= unit;
  return tank;
}

Ring inUnits(Ring ring, double unit) {
  scale(ring.points, 1.0 / unit);
  scale(ring.search, 1.0 / unit);
  ring.reach /= unit;
  return ring;
}

void putInMetres(Datum& datum, double unit) {
  scale(datum.edge_points, unit);
  scale(datum.circle, unit);
  datum.curve.control_points *= unit;
  datum.curve.rms *= unit;
  datum.curve.max_residual *= unit;
  for (Station& s : datum.stations) scale(s, unit);
  scale(datum.refined.circle, unit);
  datum.refined.sigma_radius *= unit;
  scale(datum.refined.profile, unit);
  for (StationProfile& section : datum.refined.sections) scale(section, unit);
}

}  // namespace tank_datum
