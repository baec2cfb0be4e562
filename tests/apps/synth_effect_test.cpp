#include <gtest/gtest.h>

#include <map>

#include "support/synth_scenes.h"
#include "synth/scene_file.h"

namespace tank_datum::synth::synth_effect_test {

using Json = nlohmann::ordered_json;

/// A scene file in which every option has something to act on.
Json busyScene(const std::string& kind) {
  SceneOptions scene = richScene();
  scene.scanner.count = 1;
  scene.scanner.step = radians(1.5), scene.scanner.row_step = radians(0.3);
  scene.scanner.field = "tank";
  scene.tanks[0].roof = kind == "pad" ? "dome" : "cone";
  scene.tanks[0].rings = {{3.0, 0.3, 0.02}};
  scene.tanks[0].foundation.kind = kind == "inside" ? "pad" : kind;
  scene.tanks[0].foundation.roughness = 0.001;
  scene.tanks[0].soil = {{radians(10), radians(20), 0.04, 0.25, 0.3, 0.004, 0.03}};
  scene.ground.roughness = 0.01;
  scene.clutter = {4, 4, 0.8, 6.0};
  for (const char* one : {"box", "pipe_vertical", "tree", "bund_rectangle", "nozzle"}) {
    ObjectOptions object;
    object.kind = one;
    object.azimuth = 0.1 * static_cast<double>(scene.objects.size()) - 0.2;
    scene.objects.push_back(object);
  }
  scene.scanner.inside = kind == "inside";
  scene.scanner.distance = kind == "inside" ? 4.0 : 8.0;
  scene.measurement.range_sigma = 0.001, scene.measurement.incidence_gain = 0.3;
  scene.measurement.mixed_pixels = kind == "pad";
  scene.scanner.min_elevation = radians(-25), scene.scanner.max_elevation = radians(40);
  return toJson(scene);
}

const std::vector<std::pair<const char*, Json>> kPadChanges = {
    {"/seed", 9},
    {"/offset", {1, 2, 3}},
    {"/scanner/registration/sigma_dz", 0.002},
    {"/scanner/registration/sigma_plan", 0.002},
    {"/scanner/registration/sigma_tilt_arcsec", 10},
    {"/scanner/registration/errors/0/dz", 0.002},
    {"/scanner/registration/errors/0/dx", 0.002},
    {"/scanner/registration/errors/0/dy", 0.002},
    {"/scanner/registration/errors/0/tilt_x_arcsec", 30},
    {"/scanner/registration/errors/0/tilt_y_arcsec", 30},
    {"/near_datum", 2.0},
    {"/tanks/0/x", 4},
    {"/tanks/0/y", 4},
    {"/tanks/0/radius", 11},
    {"/tanks/0/height", 7},
    {"/tanks/0/base_elevation", 1.0},
    {"/tanks/0/tilt_slope", 0.003},
    {"/tanks/0/tilt_direction_deg", 80},
    {"/tanks/0/harmonics/0/n", 3},
    {"/tanks/0/harmonics/0/amplitude", 0.005},
    {"/tanks/0/harmonics/0/phase_deg", 3},
    {"/tanks/0/dips/0/azimuth_deg", 20},
    {"/tanks/0/out_of_round/0/n", 4},
    {"/tanks/0/out_of_round/0/amplitude", 0.02},
    {"/tanks/0/out_of_round/0/phase_deg", 50},
    {"/tanks/0/out_of_round/0/growth", 2},
    {"/tanks/0/lobes/amplitude", 0.02},
    {"/tanks/0/lobes/min_length", 2},
    {"/tanks/0/lobes/max_length", 9},
    {"/tanks/0/lobes/count", 3},
    {"/tanks/0/lean_with_tilt", false},
    {"/tanks/0/lean_x", 0.01},
    {"/tanks/0/lean_y", 0.01},
    {"/tanks/0/course_height", 2},
    {"/tanks/0/course_step", 0.001},
    {"/tanks/0/course_flush", "outer"},
    {"/tanks/0/roof", "none"},
    {"/tanks/0/roof_rise", 2},
    {"/tanks/0/rings/0/height", 2},
    {"/tanks/0/rings/0/width", 0.2},
    {"/tanks/0/rings/0/thickness", 0.05},
    {"/tanks/0/foundation/kind", "crown"},
    {"/tanks/0/foundation/weld", 0.04},
    {"/tanks/0/foundation/pad_width", 0.7},
    {"/tanks/0/foundation/pad_fall", 0.03},
    {"/tanks/0/foundation/shoulder_fall", 1},
    {"/tanks/0/foundation/roughness", 0},
    {"/tanks/0/foundation/roughness_length", 0.1},
    {"/tanks/0/soil/0/azimuth_deg", 0},
    {"/tanks/0/soil/0/width_deg", 10},
    {"/tanks/0/soil/0/depth", 0.1},
    {"/tanks/0/soil/0/reach", 0.4},
    {"/tanks/0/soil/0/edge", 1.0},
    {"/tanks/0/soil/0/roughness", 0},
    {"/tanks/0/soil/0/roughness_length", 0.1},
    {"/ground/present", false},
    {"/ground/drop", 0.4},
    {"/ground/slope", 0.01},
    {"/ground/slope_direction_deg", 10},
    {"/ground/roughness", 0},
    {"/ground/roughness_length", 1},
    {"/objects/0/kind", "pipe_parallel"},
    {"/objects/0/place", "world"},
    {"/objects/0/azimuth_deg", 5},
    {"/objects/0/gap", 3},
    {"/objects/0/z", 0.5},
    {"/objects/0/yaw_deg", 30},
    {"/objects/0/length", 2},
    {"/objects/0/width", 2},
    {"/objects/0/height", 2},
    {"/objects/1/radius", 0.3},
    {"/objects/2/count", 10},
    {"/objects/3/thickness", 0.6},
    {"/clutter/boxes", 9},
    {"/clutter/pipes", 9},
    {"/clutter/min_gap", 2},
    {"/clutter/max_gap", 4},
    {"/scanner/count", 2},
    {"/scanner/distance", 9},
    {"/scanner/first_azimuth_deg", 3},
    {"/scanner/height", 2},
    {"/scanner/min_elevation_deg", -3},
    {"/scanner/max_elevation_deg", 3},
    {"/scanner/field", "full"},
    {"/scanner/step_deg", 0.5},
    {"/scanner/row_step_deg", 0.5},
    {"/scanner/max_range", 10},
    {"/scanner/jitter", false},
    {"/scanner/stations/0", {{"x", 20}, {"y", 1}}},
    {"/measurement/range_sigma", 0.002},
    {"/measurement/incidence_gain", 0.5},
    {"/measurement/max_growth", 1.1},
    {"/measurement/angle_sigma_deg", 0.01},
    {"/measurement/mixed_pixels", false},
    {"/measurement/beam_diameter", 0.01},
    {"/measurement/beam_divergence", 0.001},
    {"/measurement/blend_probability", 1},
    {"/measurement/blend_gap", 1},
    {"/measurement/outliers", 0.1},
    {"/measurement/quantum", 0.001},
    {"/measurement/thin_half", 2},
    {"/measurement/invalid", 0.1},
};

const std::vector<std::pair<const char*, Json>> kPlateChanges = {
    {"/tanks/0/foundation/plate_width", 0.08},
    {"/tanks/0/foundation/plate_thickness", 0.02},
    {"/tanks/0/foundation/plate_width_variation", 0.01},
    {"/tanks/0/foundation/ringwall_width", 0.4},
    {"/tanks/0/foundation/plate_slope", -0.03},
    {"/tanks/0/foundation/plate_slope_waves/0", {{"n", 3}, {"amplitude", 0.02}, {"phase_deg", 10}}},
    {"/tanks/0/foundation/concentric", true},
    {"/tanks/0/foundation/sectors/0", {{"rise", 0.01}, {"azimuth_deg", 10}, {"width_deg", 90}, {"edge", 0.2}}},
};

const std::vector<std::pair<const char*, Json>> kCrownChanges = {
    {"/tanks/0/foundation/crown_inner", 0.12},  {"/tanks/0/foundation/crown_outer", 0.2},
    {"/tanks/0/foundation/crown_height", 0.02}, {"/tanks/0/foundation/slab_drop", 0.05},
    {"/tanks/0/foundation/slab_width", 1.0},    {"/ground/over_foundation", true},
};

const std::vector<std::pair<const char*, Json>> kInsideChanges = {
    {"/tanks/0/thickness", 0.03},    {"/tanks/0/floor_cone", 0.01},      {"/tanks/0/roof", "floating"},
    {"/scanner/inside", false},      {"/tanks/0/foundation/weld", 0.02}, {"/tanks/0/dips/0/width_deg", 60},
    {"/tanks/0/dips/0/depth", 0.03},
};

Rows changed(Json scene, const char* place, const Json& value) {
  scene[Json::json_pointer(place)] = value;
  return rowsOf(sceneFromJson(scene));
}

TEST(SynthEffect, EveryOptionChangesTheScan) {
  const std::map<std::string, std::vector<std::pair<const char*, Json>>> all = {
      {"pad", kPadChanges}, {"annular_plate", kPlateChanges}, {"crown", kCrownChanges}, {"inside", kInsideChanges}};
  for (const auto& [kind, changes] : all) {
    const Json base = busyScene(kind);
    const Rows rows = rowsOf(sceneFromJson(base));
    ASSERT_GT(rows.size(), 1000u) << kind;
    for (const auto& [place, value] : changes) {
      Json scene = base;
      if (std::string(place) == "/ground/over_foundation") scene["ground"]["drop"] = -0.1;
      const Rows before = scene == base ? rows : rowsOf(sceneFromJson(scene));
      EXPECT_NE(changed(scene, place, value), before) << kind << " " << place;
    }
  }
}

TEST(SynthEffect, TiltMayBeGivenAcrossTheDiameter) {
  Json by_slope = busyScene("pad"), by_total = by_slope;
  by_total["tanks"][0]["tilt_slope"] = 0.0;
  by_total["tanks"][0]["tilt_total"] = 0.004 * 20.0;
  EXPECT_EQ(rowsOf(sceneFromJson(by_slope)), rowsOf(sceneFromJson(by_total)));
}

TEST(SynthEffect, ArcSpreadsTheScanners) {
  const Rows wide = changed(busyScene("pad"), "/scanner/count", 2);
  Json narrow = busyScene("pad");
  narrow["scanner"]["arc_deg"] = 90;
  EXPECT_NE(changed(narrow, "/scanner/count", 2), wide);
}

TEST(SynthEffect, TheOtherTankHidesAndTheScannersMayStandRoundIt) {
  SceneOptions scene = plainScene();
  scene.tanks.push_back(scene.tanks[0]);
  scene.tanks[1].x = 30.0, scene.tanks[1].radius = 5.0;
  const Scene built(scene);
  EXPECT_NEAR(built.cast({{18.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}, -1).t, 7.0, 1e-11);
  EXPECT_EQ(built.cast({{18.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}, -1).owner, 1);
  scene.scanner.tank = 1;
  EXPECT_NEAR(scanStations(Scene(scene))[0].position.x(), 43.0, 1e-12);
  EXPECT_EQ(truthOf(built, 4).tanks.size(), 2u);
}

}  // namespace tank_datum::synth::synth_effect_test
