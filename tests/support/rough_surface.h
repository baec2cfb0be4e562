#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace tank_datum::made_feet {

/// Heights over a plane, normally distributed and correlated as exp(-r^2 / (2 length^2)): many waves added up.
class RoughSurface {
 public:
  RoughSurface(double heights, double length, int waves = 150, unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> rate(0.0, 1.0 / length);
    std::uniform_real_distribution<double> phase(0.0, 6.283185307179586);
    for (int i = 0; i < waves; ++i) waves_.push_back({rate(random), rate(random), phase(random)});
    amplitude_ = heights * std::sqrt(2.0 / waves);
  }

  double operator()(double x, double y) const {
    double sum = 0;
    for (const Wave& w : waves_) sum += std::cos(w.x * x + w.y * y + w.phase);
    return amplitude_ * sum;
  }

 private:
  struct Wave {
    double x, y, phase;
  };
  std::vector<Wave> waves_;
  double amplitude_;
};

}  // namespace tank_datum::made_feet
