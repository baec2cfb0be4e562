#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/portable_math.h"
#include "hit.h"
#include "options.h"

namespace tank_datum::synth {

/// What a tank is at one azimuth, with derivatives by azimuth [m/rad].
struct Section {
  double datum = 0.0, datum_rate = 0.0;    ///< elevation where shell and foundation meet
  double foot = 0.0, foot_rate = 0.0;      ///< outer radius there
  double growth = 0.0, growth_rate = 0.0;  ///< of the radius from there to the top
  double lip = 0.0, lip_rate = 0.0;        ///< change of the annular plate's width
  double slope = 0.0, slope_rate = 0.0;    ///< of the annular plate, rising outwards [1]
  double rise = 0.0, rise_rate = 0.0;      ///< of ringwall, crown and slab
};

/// Bounds of a curve over azimuth: largest deviation from its mean level [m], slope [m/rad], second derivative.
struct Bound {
  double deviation = 0.0, slope = 0.0, bend = 0.0;
};

/// A ray in the tank's own frame: origin at the centre, x and y sheared so that a leaning axis is upright. Shearing
/// keeps rays straight and t unchanged.
struct TankRay {
  Eigen::Vector3d origin, direction;
  double a, b, c;  ///< rho^2 = a t^2 + 2 b t + c
  double moment;   ///< rho^2 * azimuth'

  double closest() const { return a > 0.0 ? -b / a : 0.0; }
  double rho(double t) const { return std::sqrt(std::max(0.0, (a * t + 2.0 * b) * t + c)); }
  double azimuth(double t) const {
    return portable::atan2(origin.y() + t * direction.y(), origin.x() + t * direction.x());
  }
  /// Where rho <= radius; false when nowhere.
  bool within(double radius, double& begin, double& end) const;
};

/// A point of a ray in the terms of the tank.
struct TankPoint {
  Eigen::Vector3d position;  ///< in the tank's frame
  double rho, rho_rate;
  double azimuth_rate;
  double h, h_rate;  ///< above the datum
  Section section;
};

/// Bounds of second derivatives along a ray outside a given radius, for firstRoot.
struct RayBends {
  double datum, foot, growth, lip, slope, rise, rho;  ///< [1/m]; of the slope [1/m^2]
  double azimuth_rate, h_rate;                        ///< largest first derivatives
};

/// The smooth shape of one tank: datum line, shell radius, lean. Its table is exact to 1e-9 m.
class TankShape {
 public:
  TankShape(const TankOptions& options, std::uint64_t seed);

  const TankOptions& options() const { return options_; }
  double tiltSlope() const { return tilt_slope_; }
  Eigen::Vector2d lean() const { return {lean_x_, lean_y_}; }  ///< of the axis, the tilt's share included [m/m]

  /// What the tank is in the direction of a place in its frame, the centre excepted.
  Section section(double x, double y) const;
  double courseOffset(double h) const;  ///< of the outer face from that of the lowest course [m]
  double courseRate(double h) const;
  double courseBend(double h_low, double h_high) const;  ///< bound of its second derivative
  /// Outer radius at height h above the datum, in the tank's frame.
  double outerRadius(const Section& section, double h) const;
  double innerRadius(const Section& section, double h) const;
  double footRadius(const Section& s, bool inside) const { return inside ? s.foot - options_.thickness : s.foot; }

  bool stepped(bool inner) const { return inner ? inner_stepped_ : outer_stepped_; }
  const Bound& datumBound() const { return bounds_[0]; }
  double deviation() const { return deviation_; }  ///< the outer radius is within options.radius +- this
  double lipBound() const { return bounds_[3].deviation; }
  const Bound& slopeBound() const { return bounds_[4]; }  ///< its deviation is the steepest slope
  double riseBound() const { return bounds_[5].deviation; }
  double footSlope() const { return bounds_[1].slope; }          ///< of the shell's radius at its foot [m/rad]
  double footDeviation() const { return bounds_[1].deviation; }  ///< of the shell at its foot from the circle

  TankRay local(const Ray& ray) const;
  TankPoint at(const TankRay& ray, double t) const;
  RayBends bends(const TankRay& ray, double least_rho) const;

  Eigen::Vector3d toTank(const Eigen::Vector3d& world) const;
  Eigen::Vector3d toWorld(const Eigen::Vector3d& local) const;
  /// Unit normal in the world of a gradient in the tank's frame.
  Eigen::Vector3d worldNormal(const Eigen::Vector3d& gradient) const;

 private:
  static constexpr int kCurves = 6;
  void tabulate(std::uint64_t seed);

  struct Node {
    double value[kCurves], rate[kCurves];
  };

  TankOptions options_;
  bool outer_stepped_, inner_stepped_;
  double tilt_slope_, lean_x_, lean_y_, deviation_ = 0.0;
  Bound bounds_[kCurves];    ///< datum, foot, growth, lip, slope of the plate, rise
  bool plain_ = true;        ///< without the last two
  std::vector<Node> nodes_;  ///< at equal steps of diamondAngle
};

}  // namespace tank_datum::synth
