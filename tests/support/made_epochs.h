#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/units.h"
#include "tank_datum/core/error.h"
#include "tank_datum/movement/movement.h"

/// Surveys whose shape and errors are known.
namespace tank_datum::made_epochs {

/// Standard error of the difference of two scans that all their stations share [m].
inline const double kShared = 0.0001 * std::sqrt(2.0);

/// A survey of a 30 m tank: its shape, errors of `sigma` that stations share within `window`, and a dip.
struct Survey {
  std::size_t count = 360;
  unsigned seed = 0;  ///< 0: no errors
  double sigma = 0.0003, window = 2 * kDegree, dip = 0.0, width = 10 * kDegree, lift = 0.0, tilt = 0.0, turned = 0.0;

  Epoch epoch() const {
    Epoch epoch{"survey", "ok", "refined", "foundation", {{10.0, -5.0}, 30.0}, {}};
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    const double step = 360.0 / static_cast<double>(count);
    const auto shared = static_cast<std::size_t>(std::max(1.0, std::round(window / kDegree / step)));
    std::vector<double> white(count);
    for (double& w : white) w = normal(generator) / std::sqrt(static_cast<double>(shared));
    for (std::size_t i = 0; i < count; ++i) {
      const double a = static_cast<double>(i) * step * kDegree, b = a + turned;
      double error = 0.0;
      for (std::size_t k = 0; k < shared; ++k) error += white[(i + k) % count];
      const double off = std::remainder(b - 100 * kDegree, 360 * kDegree) / (0.5 * width);
      double z = 1.0 + 0.006 * std::cos(2 * b) + 0.004 * std::sin(3 * b) + lift + tilt * std::cos(b);
      if (std::abs(off) < 1.0) z -= dip * 0.5 * (1.0 + std::cos(3.14159265358979 * off));
      epoch.stations.push_back({a, a, z + (seed > 0 ? sigma * error : 0.0), sigma, window});
    }
    return epoch;
  }
};

inline Survey with(double Survey::*field, double value, unsigned seed = 0) {
  Survey survey;
  survey.seed = seed;
  survey.*field = value;
  return survey;
}

/// What compareEpochs refuses two surveys with; empty if it compares them.
inline std::string refusal(const Epoch& a, const Epoch& b, const MovementOptions& options = {}) {
  try {
    compareEpochs(a, b, options);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Option);
    return error.what();
  }
  return "";
}

}  // namespace tank_datum::made_epochs
