#include "foot/station_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "foot/foot_profile.h"

namespace tank_datum {
namespace {

/// Where a point of a section belongs.
enum class Part { Shell, Foundation, Else };

Part partOf(const SectionPoint& p, const StationProfile& profile, double band_to) {
  constexpr double kNear = 0.03;  // of the foundation's surface, beyond any noise and roughness [m]
  if (p.z > p.d) return Part::Shell;
  const double line = profile.hasFoundation() ? profile.foundation + profile.slope * p.d : 0.0;
  return p.d <= band_to && std::abs(p.z - line) < kNear ? Part::Foundation : Part::Else;
}

/// Every n-th point, such that at most `wanted` are kept.
void keepSome(const std::vector<SectionPoint>& all, std::size_t wanted, std::vector<SectionPoint>& kept) {
  const std::size_t every = std::max<std::size_t>(1, (all.size() + wanted - 1) / wanted);
  for (std::size_t i = every / 2; i < all.size(); i += every) kept.push_back(all[i]);
}

}  // namespace

StationProfile profileOf(const FootRing& ring, const ProfileWindow& window, const FootFit& fit, const ShellLine& shell,
                         int wanted) {
  StationProfile profile;
  profile.base = window.base;
  if (fit.valid()) {
    profile.foundation = fit.z - window.base;
    profile.slope = fit.slope;
    profile.noise = fit.noise;
  }
  if (shell.seen()) {
    profile.lean = window.band.side * shell.lean;
    profile.shell_noise = shell.noise;
  }
  std::vector<FootPoint> points = ring.around(window.direction, window.half_step, window.base, window.reach);
  if (fit.valid() && points.size() < static_cast<std::size_t>(wanted)) {
    points = ring.around(window.direction, std::max(window.half_step, fit.half_width), window.base, window.reach);
  }
  std::array<std::vector<SectionPoint>, 3> parts;
  for (const FootPoint& p : points) {
    // the surface's run along the shell is taken out, as the fit does, so that a wide window draws no smear
    const double z = p.z - window.base - (fit.valid() ? fit.along * p.t + fit.bend * p.t * p.t : 0.0);
    const SectionPoint at{static_cast<float>(p.d), static_cast<float>(z)};
    parts[static_cast<std::size_t>(partOf(at, profile, window.band.to))].push_back(at);
  }
  for (const auto& part : parts)
    keepSome(part, std::max<std::size_t>(1, static_cast<std::size_t>(wanted) / 3), profile.points);
  return profile;
}

}  // namespace tank_datum
