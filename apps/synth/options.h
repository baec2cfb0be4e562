#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/units.h"
#include "tank_datum/core/error.h"

/// What a simulated scene holds: plain values with their defaults, SI and radians. Scene files carry the same names;
/// there an angle ends in _deg and is in degrees.
namespace tank_datum::synth {

constexpr double radians(double degrees) { return degrees * kPi / 180.0; }
constexpr double degrees(double radians) { return radians * 180.0 / kPi; }

/// amplitude * cos(n * azimuth - phase)
struct Harmonic {
  int n = 2;               ///< waves round the tank
  double amplitude = 0.0;  ///< [m]
  double phase = 0.0;      ///< [rad]
};

/// A harmonic of the shell's radius; at the top of the shell its amplitude is (1 + growth) times that at the foot.
struct ShellHarmonic {
  int n = 2;               ///< waves round the tank
  double amplitude = 0.0;  ///< [m]
  double phase = 0.0;      ///< [rad]
  double growth = 0.0;     ///< [1]
};

/// A local settlement of the datum, shaped cos^4, which is C3.
struct Dip {
  double azimuth = 0.0;        ///< of the lowest point [rad]
  double width = radians(10);  ///< from rim to rim [rad]
  double depth = 0.010;        ///< [m], downwards
};

/// Out-of-roundness as lobes: `count` harmonics of seeded phase, scaled so that the largest deviation is `amplitude`.
struct Lobes {
  double amplitude = 0.0;   ///< [m], 0 = none
  double min_length = 3.0;  ///< shortest wave along the shell [m]
  double max_length = 8.0;  ///< longest wave along the shell [m]
  int count = 6;            ///< harmonics
};

/// A horizontal plate round the shell: wind girder, drip ring.
struct Ring {
  double height = 10.0;      ///< of its middle above the datum [m]
  double width = 0.5;        ///< how far it stands out from the shell [m]
  double thickness = 0.010;  ///< [m]
};

/// Earth heaped against the shell over an arc, deepest at the shell, hiding the datum.
struct Soil {
  double azimuth = 0.0;             ///< of the middle of the arc [rad]
  double width = radians(20);       ///< of the arc [rad]
  double depth = 0.040;             ///< at the shell, above the datum [m]
  double reach = 0.30;              ///< where its slope ends, below the foundation's surface, from the shell [m]
  double edge = 0.30;               ///< length of its fading at both ends of the arc [m]; small = abrupt
  double roughness = 0.004;         ///< rms [m]
  double roughness_length = 0.030;  ///< correlation length [m]
};

/// A sector of the foundation round the plate that stands higher than the rest, fading to it at both ends.
struct Sector {
  double azimuth = 0.0;        ///< of the middle of the arc [rad]
  double width = radians(60);  ///< of the arc [rad]
  double rise = 0.005;         ///< of ringwall, crown and slab [m]; negative lowers
  double edge = 0.30;          ///< length of its fading at both ends of the arc [m]; small = a step
};

/// What lies outside the shell foot; heights count from the datum, distances outwards from the shell.
struct Foundation {
  std::string kind = "pad";                 ///< pad, annular_plate or crown
  double weld = 0.0;                        ///< leg of the fillet weld [m]
  double pad_width = 1.0;                   ///< to the shoulder [m]
  double pad_fall = 0.0;                    ///< slope of the pad, falling outwards [1]
  double shoulder_fall = 0.667;             ///< slope of the shoulder [1]
  double plate_width = 0.065;               ///< lip of the annular plate [m]
  double plate_thickness = 0.010;           ///< [m]
  double plate_width_variation = 0.0;       ///< largest change of the lip along the shell [m]
  double plate_slope = 0.0;                 ///< of the lip, rising outwards, mean [1]
  std::vector<Harmonic> plate_slope_waves;  ///< of that slope round the tank, amplitudes [1]
  double ringwall_width = 0.30;             ///< to the edge of the ringwall [m]
  double crown_inner = 0.100;               ///< where the concrete crown begins [m]
  double crown_outer = 0.180;               ///< and ends [m]
  double crown_height = 0.015;              ///< of the crown above the datum [m]
  double slab_drop = 0.035;                 ///< of the slab outside the crown below the datum [m]
  double slab_width = 1.5;                  ///< to the edge of the slab [m]
  double roughness = 0.0;                   ///< rms [m], everything but the weld
  double roughness_length = 0.020;          ///< correlation length [m]
  bool concentric = false;      ///< edges of ringwall, crown and slab follow the circle of the tank's radius,
                                ///< distances count from there; else a shell out of round takes them along
  std::vector<Sector> sectors;  ///< of ringwall, crown and slab
};

struct TankOptions {
  double x = 0.0, y = 0.0;          ///< centre [m]
  double radius = 30.0;             ///< of the shell's outer surface at its foot [m]
  double height = 15.0;             ///< of the shell [m]
  double thickness = 0.012;         ///< of the lowest course [m]
  double base_elevation = 0.0;      ///< mean datum elevation [m]
  double tilt_slope = 0.0;          ///< [m/m]
  double tilt_total = 0.0;          ///< the same as metres across the diameter [m]; give one of the two
  double tilt_direction = 0.0;      ///< azimuth of the highest point [rad]
  std::vector<Harmonic> harmonics;  ///< of the datum elevation
  std::vector<Dip> dips;
  std::vector<ShellHarmonic> out_of_round;
  Lobes lobes;
  bool lean_with_tilt = true;          ///< the axis stands square on the tilted base
  double lean_x = 0.0, lean_y = 0.0;   ///< further lean of the axis [m/m]
  double course_height = 2.4;          ///< [m]
  double course_step = 0.0;            ///< each course is this much thinner than the one below [m]
  std::string course_flush = "inner";  ///< the face without steps: inner or outer
  std::string roof = "none";           ///< none, cone, dome or floating
  double roof_rise = 1.5;              ///< of cone and dome at the centre [m]
  double roof_height = 10.0;           ///< of a floating roof above the base [m]
  double floor_cone = 0.0;             ///< slope of the floor, rising to the centre [1]
  std::vector<Ring> rings;
  Foundation foundation;
  std::vector<Soil> soil;
};

/// A plane; it leaves the tanks' foundations free.
struct GroundOptions {
  bool present = true;
  double drop = 0.25;              ///< at the highest side of the first foundation, below its datum [m]
  double slope = 0.0;              ///< [1]
  double slope_direction = 0.0;    ///< azimuth of uphill [rad]
  double roughness = 0.0;          ///< rms [m]
  double roughness_length = 0.30;  ///< correlation length [m]
  bool over_foundation = false;    ///< the ground may bury the foundation
};

/// A thing that stands about. Which of the sizes count depends on the kind, see objects.cpp.
struct ObjectOptions {
  std::string kind =
      "box";  ///< box, pipe_vertical, pipe_parallel, pipe_radial, nozzle, stairs, tree, bund, bund_rectangle
  std::string place = "tank";  ///< tank: by azimuth and gap; world: by x and y
  int tank = 0;                ///< index of the tank it belongs to
  double azimuth = 0.0;        ///< about the tank's centre [rad]
  double gap = 2.0;            ///< of its middle (pipe_radial: its start) from the shell [m]
  double x = 0.0, y = 0.0;     ///< [m]
  double z = 0.0;              ///< above the ground; of a nozzle above the datum [m]
  double yaw = 0.0;            ///< of its length, from outwards (tank) or +x (world) [rad]
  double length = 1.0;         ///< [m]
  double width = 0.8;          ///< [m]
  double height = 1.0;         ///< [m]
  double radius = 0.10;        ///< [m]
  double thickness = 0.30;     ///< of a bund wall [m]
  int count = 200;             ///< leaves of a tree
};

/// Seeded boxes and pipes round the first tank.
struct Clutter {
  int boxes = 0;
  int pipes = 0;
  double min_gap = 0.8;  ///< nearest to the shell [m]
  double max_gap = 6.0;  ///< farthest from the shell [m]
};

/// A scanner set up by hand.
struct StationOptions {
  double x = 0.0, y = 0.0;                              ///< [m]
  double z = std::numeric_limits<double>::quiet_NaN();  ///< [m]; missing = scanner height above the ground or floor
};

/// The error with which one scanner's points are brought into the common frame: shifted, and turned about the scanner.
/// Slopes are of the frame as the points have it: a point dx to the east of the scanner is tilt_x dx too high.
struct RegistrationError {
  int scanner = 0;                      ///< index
  double dx = 0.0, dy = 0.0, dz = 0.0;  ///< [m]
  double tilt_x = 0.0, tilt_y = 0.0;    ///< of z along x and along y [rad]
};

/// Errors of all scanners: the listed ones are as listed, the others' are drawn.
struct RegistrationOptions {
  double sigma_dz = 0.0;    ///< [m]
  double sigma_plan = 0.0;  ///< of dx and of dy [m]
  double sigma_tilt = 0.0;  ///< of either tilt [rad]
  std::vector<RegistrationError> errors;
};

struct ScannerOptions {
  std::vector<StationOptions> stations;  ///< empty = `count` of them round the tank
  int tank = 0;                          ///< index of the tank they stand round
  bool inside = false;                   ///< they stand in the tank
  int count = 6;
  double distance = 10.0;               ///< from the shell; inside: from the centre [m]
  double first_azimuth = 0.0;           ///< [rad]
  double arc = 2.0 * kPi;               ///< they are spread over [rad]
  double height = 1.8;                  ///< above the ground or floor [m]
  double min_elevation = radians(-60);  ///< lowest row [rad]
  double max_elevation = radians(80);   ///< highest row [rad]
  std::string field = "full";           ///< full circle, or tank: only the angle the tank's ring subtends
  double step = radians(0.05);          ///< between columns [rad]
  double row_step = 0.0;                ///< between rows [rad], 0 = as columns
  double max_range = 80.0;              ///< [m]
  bool jitter = true;                   ///< the grid of each station begins at a seeded angle
  RegistrationOptions registration;
};

struct MeasurementOptions {
  double range_sigma = 0.0015;      ///< at square incidence [m]
  double incidence_gain = 0.0;      ///< sigma = range_sigma * min(1 + gain * (1 / cos(i) - 1), max_growth)
  double max_growth = 5.0;          ///< [1]
  double angle_sigma = 0.0;         ///< of the beam's direction [rad]
  bool mixed_pixels = false;        ///< beams that straddle an edge return a blend
  double beam_diameter = 0.0035;    ///< at the exit [m]
  double beam_divergence = 0.0003;  ///< full angle [rad]
  double blend_probability = 0.5;   ///< of a blend across a gap in range; else the centre ray's range
  double blend_gap = 0.10;          ///< below this difference of ranges, as in the crease, always a blend [m]
  double outliers = 0.0;            ///< fraction of returns with a range drawn from 0.3 .. 1.3 of the true one
  double quantum = 0.0;             ///< resolution of the range [m], 0 = none
  double thin_half = 1.0;           ///< points with y below the tank's centre are kept with probability 1 / thin_half
  double invalid = 0.0;             ///< fraction of rows that are NaN
};

struct SceneOptions {
  std::uint64_t seed = 1;
  std::array<double, 3> offset{0.0, 0.0, 0.0};  ///< added to every output coordinate [m]
  double frame_tilt = 0.0;            ///< of the output's frame, about the middle of the first tank's base [rad]
  double frame_tilt_direction = 0.0;  ///< azimuth that it raises [rad]
  double near_datum = 0.0;            ///< keep only points this near to a datum line [m], 0 = all
  int truth_stations = 360;
  std::vector<TankOptions> tanks{TankOptions{}};
  GroundOptions ground;
  std::vector<ObjectOptions> objects;
  Clutter clutter;
  ScannerOptions scanner;
  MeasurementOptions measurement;
};

/// The first refused option, such as tanks[0].radius, or nothing.
std::optional<Refusal> firstError(const SceneOptions& options);

}  // namespace tank_datum::synth
