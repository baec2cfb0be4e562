#include <gtest/gtest.h>

#include <filesystem>

#include "support/refused.h"
#include "support/test_folder.h"
#include "synth/scene.h"
#include "synth/scene_file.h"
#include "tank_datum/core/error.h"

namespace tank_datum::synth::synth_options_test {

using Json = nlohmann::ordered_json;

std::string errorOf(const std::string& place, const Json& value) {
  Json scene = Json::object();
  scene[Json::json_pointer(place)] = value;
  try {
    return said(firstError(sceneFromJson(scene)));
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(SynthOptions, DefaultsAreUsable) { EXPECT_EQ(said(firstError(SceneOptions{})), ""); }

TEST(SynthOptions, BadValuesAreRefusedByName) {
  EXPECT_EQ(errorOf("/tanks/0/radius", -1), "tanks[0].radius, -1, expected 0.5 .. 1000");
  EXPECT_EQ(errorOf("/tanks/0/foundation/kind", "sand"),
            "tanks[0].foundation.kind, sand, expected one of pad, annular_plate, crown");
  EXPECT_EQ(errorOf("/measurement/outliers", 1.5), "measurement.outliers, 1.5, expected 0 .. 1");
  EXPECT_EQ(errorOf("/scanner/step_deg", 0), "scanner.step_deg, 0, expected 0.0001 .. 30");
}

/// Loops over courses, and whole numbers made of lengths, end; what a map's coordinates need is let through.
TEST(SynthOptions, NothingIsLargerOrFartherThanAnySite) {
  EXPECT_EQ(errorOf("/tanks/0/height", 18446744073709551616.0),
            "tanks[0].height, 1.84467e+19, expected > 0 and <= 1000");
  EXPECT_EQ(errorOf("/tanks/0/height", 1000), "");
  EXPECT_EQ(errorOf("/tanks/0/radius", 1001), "tanks[0].radius, 1001, expected 0.5 .. 1000");
  EXPECT_EQ(errorOf("/tanks/0/course_height", 0.05), "tanks[0].course_height, 0.05, expected 0.1 .. 1e+08");
  EXPECT_EQ(errorOf("/tanks/0/lobes/min_length", 0.005), "tanks[0].lobes.min_length, 0.005, expected 0.01 .. 1e+08");
  EXPECT_EQ(errorOf("/tanks/0/x", 1e8), "");
  EXPECT_EQ(errorOf("/tanks/0/x", -1.1e8), "tanks[0].x, -1.1e+08, expected -1e+08 .. 1e+08");
}

/// What is written about a value that is refused goes down into it; a million of brackets went down too far.
TEST(SynthOptions, ASceneIsNotNestedWithoutEnd) {
  const TestFolder folder;
  const auto refusal = [&folder](std::size_t lists) {
    try {
      readScene(folder.file("scene.json", "{\"a\":" + std::string(lists, '[') + std::string(lists, ']') + "}"));
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(16).find("expected no such key"), std::string::npos);
  for (const std::size_t lists : {std::size_t{17}, std::size_t{1'000'000}}) {
    EXPECT_NE(refusal(lists).find("nested deeper"), std::string::npos) << lists;
  }
}

struct Bad {
  const char* place;
  Json value;
  const char* named;
};

TEST(SynthOptions, EveryLimitNamesItsOption) {
  const std::vector<Bad> all = {
      {"/near_datum", -1, "near_datum"},
      {"/truth_stations", 0, "truth_stations"},
      {"/tanks", Json::array(), "tanks"},
      {"/seed", -1, "seed"},
      {"/offset", Json::array({1, 2}), "offset"},
      {"/tanks/0/height", 0, "tanks[0].height"},
      {"/tanks/0/thickness", 0, "thickness"},
      {"/tanks/0/tilt_slope", 0.5, "tilt_slope"},
      {"/tanks/0/tilt_total", 100, "tilt_total"},
      {"/tanks/0/lean_x", 1, "lean_x"},
      {"/tanks/0/lean_y", 1, "lean_y"},
      {"/tanks/0/course_height", 0, "course_height"},
      {"/tanks/0/course_step", 0.01, "course_step"},
      {"/tanks/0/course_flush", "both", "course_flush"},
      {"/tanks/0/roof", "thatch", "roof"},
      {"/tanks/0/roof_rise", 0, "roof_rise"},
      {"/tanks/0/roof_height", 0, "roof_height"},
      {"/tanks/0/floor_cone", 1, "floor_cone"},
      {"/tanks/0/harmonics/0/n", 0, "harmonics[0].n"},
      {"/tanks/0/dips/0/width_deg", 0, "dips[0].width_deg"},
      {"/tanks/0/out_of_round/0/n", 1000, "out_of_round[0].n"},
      {"/tanks/0/lobes/amplitude", -1, "lobes.amplitude"},
      {"/tanks/0/lobes/min_length", 0, "lobes.min_length"},
      {"/tanks/0/lobes/max_length", 1, "lobes.max_length"},
      {"/tanks/0/lobes/count", 0, "lobes.count"},
      {"/tanks/0/rings/0/height", 0, "rings[0].height"},
      {"/tanks/0/rings/0/width", 0, "rings[0].width"},
      {"/tanks/0/rings/0/thickness", 0, "rings[0].thickness"},
      {"/tanks/0/soil/0/width_deg", 0, "soil[0].width_deg"},
      {"/tanks/0/soil/0/depth", 0, "soil[0].depth"},
      {"/tanks/0/soil/0/reach", 3, "soil[0].reach"},
      {"/tanks/0/soil/0/edge", 0, "soil[0].edge"},
      {"/tanks/0/soil/0/roughness", -1, "soil[0].roughness"},
      {"/tanks/0/soil/0/roughness_length", 0, "soil[0].roughness_length"},
      {"/tanks/0/foundation/weld", -1, "weld"},
      {"/tanks/0/foundation/pad_width", 0, "pad_width"},
      {"/tanks/0/foundation/pad_fall", 2, "pad_fall"},
      {"/tanks/0/foundation/shoulder_fall", 0, "shoulder_fall"},
      {"/tanks/0/foundation/plate_width", 0, "plate_width"},
      {"/tanks/0/foundation/plate_thickness", 0, "plate_thickness"},
      {"/tanks/0/foundation/plate_width_variation", 0.1, "plate_width"},
      {"/tanks/0/foundation/ringwall_width", 0, "ringwall_width"},
      {"/tanks/0/foundation/crown_inner", 0, "crown_inner"},
      {"/tanks/0/foundation/crown_outer", 0, "crown_outer"},
      {"/tanks/0/foundation/slab_width", 0, "slab_width"},
      {"/tanks/0/foundation/roughness", -1, "foundation.roughness"},
      {"/tanks/0/foundation/roughness_length", 0, "foundation.roughness_length"},
      {"/ground/slope", -1, "ground.slope"},
      {"/ground/roughness", -1, "ground.roughness"},
      {"/ground/roughness_length", 0, "ground.roughness_length"},
      {"/objects/0/kind", "cow", "objects[0].kind"},
      {"/objects/0/place", "moon", "objects[0].place"},
      {"/objects/0/tank", 1, "objects[0].tank"},
      {"/objects/0/length", 0, "objects[0].length"},
      {"/objects/0/width", 0, "objects[0].width"},
      {"/objects/0/height", 0, "objects[0].height"},
      {"/objects/0/radius", 0, "objects[0].radius"},
      {"/objects/0/thickness", 0, "objects[0].thickness"},
      {"/objects/0/count", -1, "objects[0].count"},
      {"/clutter/boxes", -1, "clutter.boxes"},
      {"/clutter/pipes", -1, "clutter.pipes"},
      {"/clutter/min_gap", -1, "clutter.min_gap"},
      {"/clutter/max_gap", 0.1, "clutter.max_gap"},
      {"/scanner/tank", 1, "scanner.tank"},
      {"/scanner/count", 0, "scanner.count"},
      {"/scanner/distance", 0, "scanner.distance"},
      {"/scanner/arc_deg", 400, "scanner.arc_deg"},
      {"/scanner/height", 0, "scanner.height"},
      {"/scanner/min_elevation_deg", -90, "scanner.min_elevation_deg"},
      {"/scanner/max_elevation_deg", -70, "scanner.max_elevation_deg"},
      {"/scanner/field", "half", "scanner.field"},
      {"/scanner/row_step_deg", -1, "scanner.row_step_deg"},
      {"/scanner/max_range", 0, "scanner.max_range"},
      {"/scanner/registration/sigma_dz", -1, "scanner.registration.sigma_dz"},
      {"/scanner/registration/sigma_plan", -1, "scanner.registration.sigma_plan"},
      {"/scanner/registration/sigma_tilt_arcsec", -1, "scanner.registration.sigma_tilt_arcsec"},
      {"/scanner/registration/errors/0/scanner", 6, "registration.errors[0].scanner"},
      {"/scanner/registration/errors/0/tilt_x_arcsec", 40000, "errors[0].tilt_x_arcsec"},
      {"/measurement/range_sigma", -1, "range_sigma"},
      {"/measurement/incidence_gain", -1, "incidence_gain"},
      {"/measurement/max_growth", 0, "max_growth"},
      {"/measurement/angle_sigma_deg", -1, "angle_sigma_deg"},
      {"/measurement/beam_diameter", -1, "beam_diameter"},
      {"/measurement/beam_divergence", 1, "beam_divergence"},
      {"/measurement/blend_probability", 2, "blend_probability"},
      {"/measurement/blend_gap", -1, "blend_gap"},
      {"/measurement/quantum", -1, "quantum"},
      {"/measurement/thin_half", 0, "thin_half"},
      {"/measurement/invalid", -1, "measurement.invalid"},
  };
  for (const Bad& bad : all) {
    const std::string error = errorOf(bad.place, bad.value);
    EXPECT_NE(error.find(bad.named), std::string::npos) << bad.place << ": " << error;
  }
}

TEST(SynthOptions, UnknownKeysAndWrongTypesAreRefusedByName) {
  EXPECT_EQ(errorOf("/tanks/0/radios", 3), "scene: tanks[0].radios, 3, expected no such key");
  EXPECT_EQ(errorOf("/tanks/0/radius", "wide"), "scene: tanks[0].radius, \"wide\", expected a number");
  EXPECT_EQ(errorOf("/scanner/count", 2.5), "scene: scanner.count, 2.5, expected a whole number");
  EXPECT_EQ(errorOf("/scanner/inside", 1), "scene: scanner.inside, 1, expected true or false");
  EXPECT_EQ(errorOf("/comment", "fine"), "");
}

TEST(SynthOptions, BadOptionsMakeNoScene) {
  SceneOptions options;
  options.tanks[0].radius = -1.0;
  EXPECT_THROW(Scene{options}, Error);
}

TEST(SynthSceneFile, ComesBackAsWritten) {
  Json json = toJson(SceneOptions{});
  json["tanks"][0]["dips"].push_back({{"azimuth_deg", 33.3}, {"width_deg", 12.5}, {"depth", 0.01}});
  json["tanks"][0]["tilt_direction_deg"] = 123.4;
  json["scanner"]["stations"].push_back({{"x", 1.0}, {"y", 2.0}, {"z", nullptr}});
  const Json once = toJson(sceneFromJson(json));
  EXPECT_EQ(once["tanks"][0]["dips"][0]["azimuth_deg"], 33.3);
  EXPECT_EQ(once["tanks"][0]["tilt_direction_deg"], 123.4);
  EXPECT_TRUE(once["scanner"]["stations"][0]["z"].is_null());
  EXPECT_EQ(once, toJson(sceneFromJson(once)));
}

TEST(SynthSceneFile, EverySceneOfTheTestsIsUsable) {
  int scenes = 0;
  for (const auto& file : std::filesystem::directory_iterator(TANK_DATUM_TEST_SCENES)) {
    EXPECT_EQ(said(firstError(readScene(file.path().string()))), "") << file.path();
    ++scenes;
  }
  EXPECT_GE(scenes, 13);
  EXPECT_THROW(readScene("/no/such/scene.json"), Error);
}

}  // namespace tank_datum::synth::synth_options_test
