#include <gtest/gtest.h>

#include <cmath>

#include "support/synth_scenes.h"
#include "synth/truth.h"

/// An output whose frame does not stand upright.
namespace tank_datum::synth::synth_frame_test {

SceneOptions tiltedScene(double tilt_deg, double direction_deg) {
  SceneOptions scene = plainScene();
  scene.tanks.front().base_elevation = 2.0;
  scene.frame_tilt = radians(tilt_deg), scene.frame_tilt_direction = radians(direction_deg);
  return scene;
}

TEST(SynthFrame, IsTurnedAboutTheMiddleOfTheFirstTanksBase) {
  const Rows upright = rowsOf(tiltedScene(0.0, 0.0)), tilted = rowsOf(tiltedScene(2.0, 90.0));
  ASSERT_EQ(upright.size(), tilted.size());
  const Eigen::Vector3d pivot(0.0, 0.0, 2.0);
  const double sine = std::sin(radians(2.0)), cosine = std::cos(radians(2.0));
  for (std::size_t i = 0; i < upright.size() / 4; i += 97) {
    const Eigen::Vector3d p = pointOf(upright, i) - pivot, q = pointOf(tilted, i) - pivot;
    EXPECT_NEAR(q.x(), p.x(), 1e-12);
    EXPECT_NEAR(q.y(), cosine * p.y() - sine * p.z(), 1e-12);
    EXPECT_NEAR(q.z(), sine * p.y() + cosine * p.z(), 1e-12);
  }
}

TEST(SynthFrame, TruthIsAtTheAzimuthsOfTheOutput) {
  SceneOptions options = tiltedScene(2.0, 30.0);
  const double radius = options.tanks.front().radius;
  const Truth truth = truthOf(Scene(options), 36);
  EXPECT_NEAR(truth.tanks.front().x, 0.0, 1e-12);
  for (const TruthStation& s : truth.tanks.front().stations) {
    EXPECT_NEAR(std::remainder(std::atan2(s.y, s.x) - s.azimuth, 2.0 * kPi), 0.0, 1e-10);
    // a level ring, turned: a plane
    EXPECT_NEAR(s.z - 2.0, std::tan(radians(2.0)) * s.radius * std::cos(s.azimuth - radians(30.0)), 1e-9 * radius);
  }
}

TEST(SynthFrame, TiltsByTenDegreesAtMost) {
  EXPECT_TRUE(firstError(tiltedScene(10.1, 0.0)).has_value());
  EXPECT_FALSE(firstError(tiltedScene(9.9, 0.0)).has_value());
}

}  // namespace tank_datum::synth::synth_frame_test
