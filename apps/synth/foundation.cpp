#include "foundation.h"

#include <algorithm>
#include <cmath>

#include "tank_curves.h"

namespace tank_datum::synth {
namespace {

constexpr double kTouch = 1e-9;  ///< patches that meet overlap by this [m]

/// How full the heap is at an azimuth, 0 .. 1, and its derivative.
Sample fullness(const Soil& soil, double radius, double azimuth) {
  const double from_middle = azimuthDifference(azimuth, soil.azimuth), scale = radius / soil.edge;
  const double t = std::clamp((soil.width / 2.0 - std::abs(from_middle)) * scale, 0.0, 1.0);
  const Fade fade(t);
  return {fade.value, -std::copysign(scale * fade.rate, from_middle)};
}

}  // namespace

double FoundationShape::soilHeight(const Heap& heap, double azimuth, double d) const {
  const double full = fullness(heap.options, tank_.options().radius, azimuth).gap;
  return heap.base + (heap.options.depth - heap.base) * full * (1.0 - d / heap.options.reach);
}

bool FoundationShape::buried(double azimuth) const {
  return std::any_of(heaps_.begin(), heaps_.end(), [&](const Heap& h) { return soilHeight(h, azimuth, 0.0) > 0.0; });
}

bool Span::clipHeight(double low, double high) {
  const double z = ray.origin.z(), dz = ray.direction.z();
  if (std::abs(dz) < 1e-12) return z >= low && z <= high;
  const double at_low = (low - z) / dz, at_high = (high - z) / dz;
  begin = std::max(begin, std::min(at_low, at_high));
  end = std::min(end, std::max(at_low, at_high));
  return begin < end;
}

bool Span::clipRadius(double low, double high) {
  double enter, leave;
  if (!ray.within(high, enter, leave)) return false;
  begin = std::max(begin, enter);
  end = std::min(end, leave);
  if (begin < end && ray.within(low, enter, leave)) {  // leave out the hole, when nothing of the far side is meant
    if (begin >= enter) begin = std::max(begin, leave);
    if (end <= leave) end = std::min(end, enter);
  }
  return begin < end;
}

bool FoundationShape::clip(const Patch& patch, Span& span) const {
  const TankOptions& o = tank_.options();
  const double rough = patch.rough ? noise_.bound() : 0.0;
  const double margin = tank_.datumBound().deviation + 1e-6 + rough + levelBound(patch);
  const double one = patch.h0, other = patch.riser ? patch.bottom : patch.height(patch.d1);
  const double low = o.base_elevation + std::min(one, other) - margin;
  const double slack = tank_.deviation() + tank_.lipBound() + 1e-6;
  return span.clipHeight(low, o.base_elevation + std::max(one, other) + margin) &&
         span.clipRadius(o.radius + patch.d0 - slack, o.radius + patch.d1 + slack);
}

void FoundationShape::trace(const TankRay& local, int owner, Hit& hit) const {
  const TankOptions& o = tank_.options();
  double begin, end;
  if (!local.within(o.radius + tank_.deviation() + width_ + tank_.lipBound(), begin, end)) return;
  begin = std::max(begin, 0.0);
  if (begin >= std::min(end, hit.t)) return;
  const RayBends bends = tank_.bends(local, o.radius - tank_.deviation());
  for (std::size_t i = patches_.size(); i-- > 0;) {  // those farther out are met first
    const Patch& patch = patches_[i];
    Span span{local, bends, begin, std::min(end, hit.t)};
    if (!clip(patch, span)) continue;
    const double t = patch.riser ? crossRiser(patch, span) : crossBand(patch, span);
    if (t < hit.t) hit = {t, patch.surface, owner, static_cast<int>(i), normal(patch, tank_.at(local, t))};
  }
  const double spread = tank_.datumBound().deviation + 1e-6;
  for (std::size_t i = 0; i < heaps_.size(); ++i) {
    const Heap& heap = heaps_[i];
    Span span{local, bends, begin, std::min(end, hit.t)};
    const double high = o.base_elevation + spread + heap.options.depth + heap.noise.bound();
    if (!span.clipHeight(o.base_elevation - spread + heap.base - heap.noise.bound(), high)) continue;
    const double slack = tank_.deviation() + 1e-6;
    if (!span.clipRadius(o.radius - slack, o.radius + heap.options.reach + slack)) continue;
    const double t = crossHeap(heap, span);
    if (t < hit.t) hit = {t, Surface::Soil, owner, static_cast<int>(i), Eigen::Vector3d::UnitZ()};
  }
}

/// Where an edge that stands at d lies here, from the shell, and how that changes along the ray.
Sample FoundationShape::edgeOf(Edge edge, double d, const TankPoint& p) const {
  const Section& s = p.section;
  if (edge == Edge::Lip) return {d + s.lip, s.lip_rate * p.azimuth_rate};
  if (edge == Edge::Circle) return {d + tank_.options().radius - s.foot, -s.foot_rate * p.azimuth_rate};
  return {d, 0.0};
}

/// What the height of a patch's level above the datum is at a distance d from the shell, and how it changes.
Sample FoundationShape::levelOf(const Patch& patch, double d, double d_rate, const TankPoint& p) const {
  const Section& s = p.section;
  if (patch.level == Level::Plate) return {s.slope * d, s.slope * d_rate + s.slope_rate * p.azimuth_rate * d};
  if (patch.level == Level::Sector) return {s.rise, s.rise_rate * p.azimuth_rate};
  return {0.0, 0.0};
}

/// The most that level may be, either way [m].
double FoundationShape::levelBound(const Patch& patch) const {
  if (patch.level == Level::Plate) return tank_.slopeBound().deviation * (patch.d1 + tank_.lipBound());
  return patch.level == Level::Sector ? tank_.riseBound() : 0.0;
}

double FoundationShape::crossBand(const Patch& patch, const Span& span) const {
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot, d_rate = p.rho_rate - p.section.foot_rate * p.azimuth_rate;
    const ValueNoise::Height rough = patch.rough ? noise_.at(p.position.x(), p.position.y()) : ValueNoise::Height{};
    const Sample level = levelOf(patch, d, d_rate, p);
    const Eigen::Vector3d& v = span.ray.direction;
    return Sample{patch.facing * (p.h - patch.height(d) - level.gap - rough.value),
                  patch.facing * (p.h_rate + patch.fall * d_rate - level.rate - rough.dx * v.x() - rough.dy * v.y())};
  };
  const auto within = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot;
    return d >= edgeOf(patch.at0, patch.d0, p).gap - kTouch && d <= edgeOf(patch.at1, patch.d1, p).gap + kTouch;
  };
  const RayBends& bends = span.bends;
  const double steepest = patch.level == Level::Plate ? tank_.slopeBound().deviation : 0.0;
  const double widest = patch.d1 + 2.0 * (tank_.deviation() + tank_.lipBound());  // as far as a root is looked for
  const double fastest = 1.0 + tank_.footSlope() * bends.azimuth_rate;
  const double level_bend = patch.level == Level::Plate
                                ? bends.slope * widest + 2.0 * tank_.slopeBound().slope * bends.azimuth_rate * fastest
                            : patch.level == Level::Sector ? bends.rise
                                                           : 0.0;
  const double rough_bend = patch.rough ? noise_.bend() * span.ray.a : 0.0;
  const double bend =
      bends.datum + (std::abs(patch.fall) + steepest) * (bends.rho + bends.foot) + level_bend + rough_bend;
  return firstAcceptedRoot(gap, bend, span.begin, span.end, within);
}

double FoundationShape::crossRiser(const Patch& patch, const Span& span) const {
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const Sample edge = edgeOf(patch.at0, patch.d0, p);
    return Sample{patch.facing * (p.rho - p.section.foot - edge.gap),
                  patch.facing * (p.rho_rate - p.section.foot_rate * p.azimuth_rate - edge.rate)};
  };
  const double begin = patch.facing > 0.0 ? span.begin : std::max(span.begin, span.ray.closest());
  if (begin > span.end || gap(begin).gap <= 0.0) return kNever;
  const double bend = span.bends.foot + span.bends.lip + (patch.facing > 0.0 ? 0.0 : span.bends.rho);
  const double t = firstRoot(gap, bend, begin, span.end);
  if (t > span.end) return kNever;
  const TankPoint p = tank_.at(span.ray, t);
  const double rough = patch.rough ? noise_.at(p.position.x(), p.position.y()).value : 0.0;
  const double top = patch.h0 + levelOf(patch, p.rho - p.section.foot, 0.0, p).gap;
  return p.h <= top + rough + kTouch && p.h >= patch.bottom - noise_.bound() ? t : kNever;
}

double FoundationShape::crossHeap(const Heap& heap, const Span& span) const {
  const Soil& soil = heap.options;
  const double first = span.ray.azimuth(span.begin), sweep = azimuthDifference(span.ray.azimuth(span.end), first);
  const double middle = azimuthDifference(first + sweep / 2.0, soil.azimuth);
  if (std::abs(middle) > soil.width / 2.0 + std::abs(sweep) / 2.0 + 1e-6) return kNever;
  const double size = soil.depth - heap.base, radius = tank_.options().radius;
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot, d_rate = p.rho_rate - p.section.foot_rate * p.azimuth_rate;
    const ValueNoise::Height rough = heap.noise.at(p.position.x(), p.position.y());
    const Sample full = fullness(soil, radius, span.ray.azimuth(t));
    const Eigen::Vector3d& v = span.ray.direction;
    const double slide = full.rate * p.azimuth_rate * (1.0 - d / soil.reach) - full.gap * d_rate / soil.reach;
    return Sample{p.h - heap.base - size * full.gap * (1.0 - d / soil.reach) - rough.value,
                  p.h_rate - size * slide - rough.dx * v.x() - rough.dy * v.y()};
  };
  const auto within = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot;
    return d >= -kTouch && d <= soil.reach && fullness(soil, radius, span.ray.azimuth(t)).gap > 0.0;
  };
  const double turn = span.bends.azimuth_rate, scale = radius / soil.edge;
  const double fade = Fade::kMaxBend * scale * scale * turn * turn +
                      2.0 * Fade::kMaxRate * scale * turn * (1.0 / soil.reach + 1.0 / radius);
  const double bend = span.bends.datum + heap.noise.bend() * span.ray.a +
                      size * (fade + (span.bends.rho + span.bends.foot) / soil.reach);
  return firstAcceptedRoot(gap, bend, span.begin, span.end, within);
}

Eigen::Vector3d FoundationShape::normal(const Patch& patch, const TankPoint& p) const {
  const double cosine = p.position.x() / p.rho, sine = p.position.y() / p.rho;
  const double slope = patch.level == Level::Plate ? p.section.slope : 0.0;
  const double out = patch.riser ? 1.0 : patch.fall - slope, up = patch.riser ? 0.0 : 1.0;
  const double turn = -(up * p.section.datum_rate + out * p.section.foot_rate) / p.rho;
  return tank_.worldNormal({out * cosine - turn * sine, out * sine + turn * cosine, up});
}

}  // namespace tank_datum::synth
