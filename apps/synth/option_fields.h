#pragma once

#include "options.h"

/// Each option's name and limits, once. A visitor reads, writes or checks them.
namespace tank_datum::synth {

/// What a number may be; `open` excludes the lower end.
struct Limit {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;
};

inline Limit anyNumber() { return {}; }
inline Limit above(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
inline Limit atLeast(double low) { return {low, std::numeric_limits<double>::infinity(), false}; }
inline Limit aboveUpTo(double low, double high) { return {low, high, true}; }
inline Limit within(double low, double high) { return {low, high, false}; }

template <class Visitor>
void fields(Visitor& v, Harmonic& o) {
  v.integer("n", o.n, within(1, 200));
  v.number("amplitude", o.amplitude);
  v.angle("phase_deg", o.phase);
}

template <class Visitor>
void fields(Visitor& v, ShellHarmonic& o) {
  v.integer("n", o.n, within(1, 200));
  v.number("amplitude", o.amplitude);
  v.angle("phase_deg", o.phase);
  v.number("growth", o.growth);
}

template <class Visitor>
void fields(Visitor& v, Dip& o) {
  v.angle("azimuth_deg", o.azimuth);
  v.angle("width_deg", o.width, within(2, 360));
  v.number("depth", o.depth);
}

template <class Visitor>
void fields(Visitor& v, Lobes& o) {
  v.number("amplitude", o.amplitude, atLeast(0));
  v.number("min_length", o.min_length, atLeast(0.01));
  v.number("max_length", o.max_length, above(0));
  v.integer("count", o.count, within(1, 100));
}

template <class Visitor>
void fields(Visitor& v, Ring& o) {
  v.number("height", o.height, above(0));
  v.number("width", o.width, above(0));
  v.number("thickness", o.thickness, above(0));
}

template <class Visitor>
void fields(Visitor& v, Soil& o) {
  v.angle("azimuth_deg", o.azimuth);
  v.angle("width_deg", o.width, within(0.1, 360));
  v.number("depth", o.depth, above(0));
  v.number("reach", o.reach, above(0));
  v.number("edge", o.edge, atLeast(0.005));
  v.number("roughness", o.roughness, atLeast(0));
  v.number("roughness_length", o.roughness_length, atLeast(0.001));
}

template <class Visitor>
void fields(Visitor& v, Sector& o) {
  v.angle("azimuth_deg", o.azimuth);
  v.angle("width_deg", o.width, within(0.1, 360));
  v.number("rise", o.rise);
  v.number("edge", o.edge, atLeast(0.05));
}

template <class Visitor>
void fields(Visitor& v, Foundation& o) {
  v.choice("kind", o.kind, {"pad", "annular_plate", "crown"});
  v.number("weld", o.weld, within(0, 0.05));
  v.number("pad_width", o.pad_width, above(0));
  v.number("pad_fall", o.pad_fall, within(-0.5, 0.5));
  v.number("shoulder_fall", o.shoulder_fall, within(0.05, 10));
  v.number("plate_width", o.plate_width, above(0));
  v.number("plate_thickness", o.plate_thickness, above(0));
  v.number("plate_width_variation", o.plate_width_variation, atLeast(0));
  v.number("plate_slope", o.plate_slope, within(-0.3, 0.3));
  v.list("plate_slope_waves", o.plate_slope_waves);
  v.number("ringwall_width", o.ringwall_width, above(0));
  v.number("crown_inner", o.crown_inner, above(0));
  v.number("crown_outer", o.crown_outer, above(0));
  v.number("crown_height", o.crown_height);
  v.number("slab_drop", o.slab_drop);
  v.number("slab_width", o.slab_width, above(0));
  v.number("roughness", o.roughness, atLeast(0));
  v.number("roughness_length", o.roughness_length, atLeast(0.001));
  v.flag("concentric", o.concentric);
  v.list("sectors", o.sectors);
}

template <class Visitor>
void fields(Visitor& v, TankOptions& o) {
  v.number("x", o.x);
  v.number("y", o.y);
  v.number("radius", o.radius, within(0.5, 1000));
  v.number("height", o.height, aboveUpTo(0, 1000));
  v.number("thickness", o.thickness, above(0));
  v.number("base_elevation", o.base_elevation);
  v.number("tilt_slope", o.tilt_slope, within(-0.1, 0.1));
  v.number("tilt_total", o.tilt_total);
  v.angle("tilt_direction_deg", o.tilt_direction);
  v.list("harmonics", o.harmonics);
  v.list("dips", o.dips);
  v.list("out_of_round", o.out_of_round);
  v.group("lobes", o.lobes);
  v.flag("lean_with_tilt", o.lean_with_tilt);
  v.number("lean_x", o.lean_x, within(-0.1, 0.1));
  v.number("lean_y", o.lean_y, within(-0.1, 0.1));
  v.number("course_height", o.course_height, atLeast(0.1));
  v.number("course_step", o.course_step);
  v.choice("course_flush", o.course_flush, {"inner", "outer"});
  v.choice("roof", o.roof, {"none", "cone", "dome", "floating"});
  v.number("roof_rise", o.roof_rise, above(0));
  v.number("roof_height", o.roof_height, above(0));
  v.number("floor_cone", o.floor_cone, within(-0.2, 0.2));
  v.list("rings", o.rings);
  v.group("foundation", o.foundation);
  v.list("soil", o.soil);
}

template <class Visitor>
void fields(Visitor& v, GroundOptions& o) {
  v.flag("present", o.present);
  v.number("drop", o.drop);
  v.number("slope", o.slope, within(0, 0.5));
  v.angle("slope_direction_deg", o.slope_direction);
  v.number("roughness", o.roughness, atLeast(0));
  v.number("roughness_length", o.roughness_length, atLeast(0.005));
  v.flag("over_foundation", o.over_foundation);
}

template <class Visitor>
void fields(Visitor& v, ObjectOptions& o) {
  v.choice(
      "kind", o.kind,
      {"box", "pipe_vertical", "pipe_parallel", "pipe_radial", "nozzle", "stairs", "tree", "bund", "bund_rectangle"});
  v.choice("place", o.place, {"tank", "world"});
  v.integer("tank", o.tank, atLeast(0));
  v.angle("azimuth_deg", o.azimuth);
  v.number("gap", o.gap);
  v.number("x", o.x);
  v.number("y", o.y);
  v.number("z", o.z);
  v.angle("yaw_deg", o.yaw);
  v.number("length", o.length, above(0));
  v.number("width", o.width, above(0));
  v.number("height", o.height, above(0));
  v.number("radius", o.radius, above(0));
  v.number("thickness", o.thickness, above(0));
  v.integer("count", o.count, within(0, 100000));
}

template <class Visitor>
void fields(Visitor& v, Clutter& o) {
  v.integer("boxes", o.boxes, within(0, 100000));
  v.integer("pipes", o.pipes, within(0, 100000));
  v.number("min_gap", o.min_gap, atLeast(0));
  v.number("max_gap", o.max_gap, atLeast(0));
}

template <class Visitor>
void fields(Visitor& v, StationOptions& o) {
  v.number("x", o.x);
  v.number("y", o.y);
  v.optional("z", o.z);
}

template <class Visitor>
void fields(Visitor& v, RegistrationError& o) {
  v.integer("scanner", o.scanner, within(0, 9999));
  v.number("dx", o.dx);
  v.number("dy", o.dy);
  v.number("dz", o.dz);
  v.arcsec("tilt_x_arcsec", o.tilt_x, within(-36000, 36000));
  v.arcsec("tilt_y_arcsec", o.tilt_y, within(-36000, 36000));
}

template <class Visitor>
void fields(Visitor& v, RegistrationOptions& o) {
  v.number("sigma_dz", o.sigma_dz, atLeast(0));
  v.number("sigma_plan", o.sigma_plan, atLeast(0));
  v.arcsec("sigma_tilt_arcsec", o.sigma_tilt, within(0, 36000));
  v.list("errors", o.errors);
}

template <class Visitor>
void fields(Visitor& v, ScannerOptions& o) {
  v.list("stations", o.stations);
  v.integer("tank", o.tank, atLeast(0));
  v.flag("inside", o.inside);
  v.integer("count", o.count, within(1, 10000));
  v.number("distance", o.distance, atLeast(0));
  v.angle("first_azimuth_deg", o.first_azimuth);
  v.angle("arc_deg", o.arc, within(0, 360));
  v.number("height", o.height, above(0));
  v.angle("min_elevation_deg", o.min_elevation, within(-89, 89));
  v.angle("max_elevation_deg", o.max_elevation, within(-89, 89));
  v.choice("field", o.field, {"full", "tank"});
  v.angle("step_deg", o.step, within(1e-4, 30));
  v.angle("row_step_deg", o.row_step, within(0, 30));
  v.number("max_range", o.max_range, above(0));
  v.flag("jitter", o.jitter);
  v.group("registration", o.registration);
}

template <class Visitor>
void fields(Visitor& v, MeasurementOptions& o) {
  v.number("range_sigma", o.range_sigma, atLeast(0));
  v.number("incidence_gain", o.incidence_gain, atLeast(0));
  v.number("max_growth", o.max_growth, atLeast(1));
  v.angle("angle_sigma_deg", o.angle_sigma, atLeast(0));
  v.flag("mixed_pixels", o.mixed_pixels);
  v.number("beam_diameter", o.beam_diameter, atLeast(0));
  v.number("beam_divergence", o.beam_divergence, within(0, 0.1));
  v.number("blend_probability", o.blend_probability, within(0, 1));
  v.number("blend_gap", o.blend_gap, atLeast(0));
  v.number("outliers", o.outliers, within(0, 1));
  v.number("quantum", o.quantum, atLeast(0));
  v.number("thin_half", o.thin_half, atLeast(1));
  v.number("invalid", o.invalid, within(0, 1));
}

template <class Visitor>
void fields(Visitor& v, SceneOptions& o) {
  v.unsignedInteger("seed", o.seed);
  v.triple("offset", o.offset);
  v.angle("frame_tilt_deg", o.frame_tilt, within(0, 10));
  v.angle("frame_tilt_direction_deg", o.frame_tilt_direction);
  v.number("near_datum", o.near_datum, atLeast(0));
  v.integer("truth_stations", o.truth_stations, within(1, 1000000));
  v.list("tanks", o.tanks);
  v.group("ground", o.ground);
  v.list("objects", o.objects);
  v.group("clutter", o.clutter);
  v.group("scanner", o.scanner);
  v.group("measurement", o.measurement);
}

}  // namespace tank_datum::synth
