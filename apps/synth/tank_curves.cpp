#include "tank_curves.h"

#include <algorithm>
#include <cmath>

#include "core/portable_math.h"
#include "random.h"
#include "value_noise.h"

namespace tank_datum::synth {

double azimuthDifference(double a, double b) { return std::remainder(a - b, 2.0 * kPi); }

double tiltSlope(const TankOptions& tank) {
  return tank.tilt_total != 0.0 ? tank.tilt_total / (2.0 * tank.radius) : tank.tilt_slope;
}

Curve datumCurve(const TankOptions& tank, double azimuth) {
  const double tilt = tiltSlope(tank) * tank.radius, from_high = azimuth - tank.tilt_direction;
  Curve curve{tank.base_elevation + tilt * portable::cos(from_high), -tilt * portable::sin(from_high)};
  for (const Harmonic& one : tank.harmonics) {
    const double angle = one.n * azimuth - one.phase;
    curve.add(one.amplitude * portable::cos(angle), -one.n * one.amplitude * portable::sin(angle));
  }
  for (const Dip& dip : tank.dips) {
    const double scale = kPi / dip.width, angle = scale * azimuthDifference(azimuth, dip.azimuth);
    if (std::abs(angle) >= kPi / 2.0) continue;
    const double c = portable::cos(angle);
    curve.add(-dip.depth * c * c * c * c, 4.0 * dip.depth * c * c * c * portable::sin(angle) * scale);
  }
  return curve;
}

Curve plateSlopeCurve(const TankOptions& tank, double azimuth) {
  Curve curve{tank.foundation.plate_slope, 0.0};
  for (const Harmonic& one : tank.foundation.plate_slope_waves) {
    const double angle = one.n * azimuth - one.phase;
    curve.add(one.amplitude * portable::cos(angle), -one.n * one.amplitude * portable::sin(angle));
  }
  return curve;
}

Curve sectorCurve(const TankOptions& tank, double azimuth) {
  Curve curve;
  for (const Sector& sector : tank.foundation.sectors) {
    const double from_middle = azimuthDifference(azimuth, sector.azimuth), scale = tank.radius / sector.edge;
    const Fade fade(std::clamp((sector.width / 2.0 - std::abs(from_middle)) * scale, 0.0, 1.0));
    curve.add(sector.rise * fade.value, -std::copysign(sector.rise * scale * fade.rate, from_middle));
  }
  return curve;
}

Curve harmonicCurve(const std::vector<ShellHarmonic>& harmonics, double azimuth, bool growth) {
  Curve curve;
  for (const ShellHarmonic& one : harmonics) {
    const double size = one.amplitude * (growth ? one.growth : 1.0), angle = one.n * azimuth - one.phase;
    curve.add(size * portable::cos(angle), -one.n * size * portable::sin(angle));
  }
  return curve;
}

namespace {

/// Scales harmonics so that their sum's largest deviation is `amplitude`.
void scaleTo(double amplitude, std::vector<ShellHarmonic>& harmonics) {
  double largest = 0.0;
  for (int i = 0; i < 20000; ++i)
    largest = std::max(largest, std::abs(harmonicCurve(harmonics, 2.0 * kPi * i / 20000.0, false).value));
  for (ShellHarmonic& one : harmonics) one.amplitude *= amplitude / largest;
}

std::vector<ShellHarmonic> seededLobes(const Lobes& lobes, double radius, Random random) {
  std::vector<ShellHarmonic> harmonics;
  for (int i = 0; i < lobes.count; ++i) {
    const double share = lobes.count == 1 ? 0.5 : static_cast<double>(i) / (lobes.count - 1);
    const double length = lobes.min_length * portable::pow(lobes.max_length / lobes.min_length, share);
    const double waves = std::round(2.0 * kPi * radius / length);
    harmonics.push_back({static_cast<int>(std::max(2.0, waves)), 1.0, random.uniform(0.0, 2.0 * kPi), 0.0});
  }
  scaleTo(lobes.amplitude, harmonics);
  return harmonics;
}

}  // namespace

std::vector<ShellHarmonic> shellHarmonics(const TankOptions& tank, std::uint64_t seed) {
  std::vector<ShellHarmonic> all = tank.out_of_round;
  if (tank.lobes.amplitude > 0.0) {
    const auto lobes = seededLobes(tank.lobes, tank.radius, Random({seed, 101}));
    all.insert(all.end(), lobes.begin(), lobes.end());
  }
  return all;
}

std::vector<ShellHarmonic> lipHarmonics(const TankOptions& tank, std::uint64_t seed) {
  const double variation = tank.foundation.plate_width_variation;
  if (variation == 0.0) return {};
  return seededLobes({variation, 1.5, 6.0, 4}, tank.radius, Random({seed, 102}));
}

}  // namespace tank_datum::synth
