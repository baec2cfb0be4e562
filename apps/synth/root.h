#pragma once

#include <cmath>
#include <limits>

namespace tank_datum::synth {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// A signed distance to a surface along a ray and its derivative.
struct Sample {
  double gap, rate;
};

/// Where the gap first falls to zero in [begin, end], or `never`. A gap <= 0 at the begin counts at once.
///
/// From a sample, gap(t + s) >= gap + rate * s - bend * s^2 / 2, so the smallest root s of the right side is a step
/// that cannot pass the surface; near it the step becomes Newton's. No root is missed and there is no marching bias.
/// @param bend  bound on how far the second derivative goes below zero in [begin, end]
template <class Gap>
double firstRoot(const Gap& gap, double bend, double begin, double end) {
  constexpr double kReached = 2e-12;  // [m]
  double t = begin;
  for (int i = 0; i < 5000 && t <= end; ++i) {
    const Sample s = gap(t);
    if (s.gap <= kReached) return t;
    const double fall = std::sqrt(s.rate * s.rate + 2.0 * bend * s.gap) - s.rate;
    if (fall <= 0.0) return kNever;
    t += 2.0 * s.gap / fall;
  }
  return kNever;
}

/// The first root in [begin, end] that `accept` takes; the ray may dip below the surface's extension in between.
template <class Gap, class Accept>
double firstAcceptedRoot(const Gap& gap, double bend, double begin, double end, const Accept& accept) {
  const auto below = [&gap](double t) {
    const Sample s = gap(t);
    return Sample{-s.gap, -s.rate};
  };
  double t = begin;
  for (int i = 0; i < 200 && t <= end; ++i) {
    if (gap(t).gap > 0.0) {
      t = firstRoot(gap, bend, t, end);
      if (t > end || accept(t)) return t;
    }
    t = firstRoot(below, bend, t + 1e-9, end) + 1e-9;
  }
  return kNever;
}

}  // namespace tank_datum::synth
