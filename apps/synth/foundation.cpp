#include "foundation.h"

#include <algorithm>
#include <cmath>

#include "tank_curves.h"

namespace tank_datum::synth {
namespace {

constexpr double kTouch = 1e-9;  ///< patches that meet overlap by this [m]

}  // namespace

FoundationShape::FoundationShape(const TankShape& tank, double depth, std::uint64_t seed)
    : tank_(tank),
      noise_(mixed({seed, 201}), tank.options().foundation.roughness, tank.options().foundation.roughness_length) {
  addProfile(depth);
  addHeaps(seed);
  addRings();
}

void FoundationShape::band(Surface surface, double d0, double h0, double d1, double h1, bool d0_lip, bool d1_lip) {
  patches_.push_back({surface, false, d0, d1, d0_lip, d1_lip, h0, (h0 - h1) / (d1 - d0), 0.0, 1.0, true});
  width_ = std::max(width_, d1);
}

void FoundationShape::riser(Surface surface, double d, double top, double bottom, double facing, bool lip) {
  patches_.push_back({surface, true, d, d, lip, lip, top, 0.0, bottom, facing, true});
}

void FoundationShape::addProfile(double depth) {
  const Foundation& f = tank_.options().foundation;
  const double plate = -f.plate_thickness;
  if (f.kind == "pad") {
    const double edge = -f.pad_fall * f.pad_width;
    band(Surface::Pad, 0.0, 0.0, f.pad_width, edge);
    band(Surface::Shoulder, f.pad_width, edge, f.pad_width + (depth + edge) / f.shoulder_fall, -depth);
    mask_width_ = f.pad_width;
  } else if (f.kind == "annular_plate") {
    band(Surface::AnnularPlate, 0.0, 0.0, f.plate_width, 0.0, false, true);
    riser(Surface::AnnularPlate, f.plate_width, 0.0, plate, 1.0, true);
    band(Surface::Ringwall, f.plate_width, plate, f.ringwall_width, plate, true, false);
    riser(Surface::Ringwall, f.ringwall_width, plate, -depth, 1.0);
    mask_width_ = f.ringwall_width;
  } else {
    band(Surface::AnnularPlate, 0.0, 0.0, f.plate_width, 0.0, false, true);
    riser(Surface::AnnularPlate, f.plate_width, 0.0, plate, 1.0, true);
    band(Surface::Slab, f.plate_width, plate, f.crown_inner, plate, true, false);
    riser(Surface::Crown, f.crown_inner, f.crown_height, plate, -1.0);
    band(Surface::Crown, f.crown_inner, f.crown_height, f.crown_outer, f.crown_height);
    riser(Surface::Crown, f.crown_outer, f.crown_height, -f.slab_drop, 1.0);
    band(Surface::Slab, f.crown_outer, -f.slab_drop, f.slab_width, -f.slab_drop);
    riser(Surface::Slab, f.slab_width, -f.slab_drop, -depth, 1.0);
    mask_width_ = f.slab_width;
  }
  if (f.weld == 0.0) return;
  band(Surface::Weld, 0.0, f.weld, f.weld + noise_.bound(), -noise_.bound());
  patches_.back().rough = false;
}

void FoundationShape::addRings() {
  for (const Ring& ring : tank_.options().rings) {
    const double top = ring.height + ring.thickness / 2.0, bottom = ring.height - ring.thickness / 2.0;
    band(Surface::Ring, -2.0 * tank_.deviation(), top, ring.width, top);
    patches_.back().rough = false;
    band(Surface::Ring, -2.0 * tank_.deviation(), bottom, ring.width, bottom);
    patches_.back().rough = false;
    patches_.back().facing = -1.0;
    riser(Surface::Ring, ring.width, top, bottom, 1.0);
    patches_.back().rough = false;
  }
}

void FoundationShape::addHeaps(std::uint64_t seed) {
  std::uint64_t number = 0;
  for (const Soil& soil : tank_.options().soil) {
    Heap heap{soil, 0.0, ValueNoise(mixed({seed, 202, number++}), soil.roughness, soil.roughness_length)};
    for (int i = 0; i <= 1000; ++i) heap.base = std::min(heap.base, profile(soil.reach * i / 1000.0, 0.0));
    heap.base -= 0.01 + heap.noise.bound() + noise_.bound();
    width_ = std::max(width_, soil.reach);
    heaps_.push_back(heap);
  }
}

double FoundationShape::profile(double d, double lip) const {
  double highest = -kNever;
  for (const Patch& p : patches_) {
    if (p.riser || p.surface == Surface::Weld || p.surface == Surface::Ring) continue;
    const bool here = d >= p.d0 + (p.d0_lip ? lip : 0.0) && d <= p.d1 + (p.d1_lip ? lip : 0.0);
    if (here) highest = std::max(highest, p.height(d));
  }
  return std::isinf(highest) ? 0.0 : highest;
}

namespace {

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
  const double margin = tank_.datumBound().deviation + 1e-6 + (patch.rough ? noise_.bound() : 0.0);
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

double FoundationShape::crossBand(const Patch& patch, const Span& span) const {
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot, d_rate = p.rho_rate - p.section.foot_rate * p.azimuth_rate;
    const ValueNoise::Height rough = patch.rough ? noise_.at(p.position.x(), p.position.y()) : ValueNoise::Height{};
    const Eigen::Vector3d& v = span.ray.direction;
    return Sample{patch.facing * (p.h - patch.height(d) - rough.value),
                  patch.facing * (p.h_rate + patch.fall * d_rate - rough.dx * v.x() - rough.dy * v.y())};
  };
  const auto within = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double d = p.rho - p.section.foot, lip = p.section.lip;
    return d >= patch.d0 + (patch.d0_lip ? lip : 0.0) - kTouch && d <= patch.d1 + (patch.d1_lip ? lip : 0.0) + kTouch;
  };
  const double rough_bend = patch.rough ? noise_.bend() * span.ray.a : 0.0;
  const double bend = span.bends.datum + std::abs(patch.fall) * (span.bends.rho + span.bends.foot) + rough_bend;
  return firstAcceptedRoot(gap, bend, span.begin, span.end, within);
}

double FoundationShape::crossRiser(const Patch& patch, const Span& span) const {
  const auto gap = [&](double t) {
    const TankPoint p = tank_.at(span.ray, t);
    const double lip = patch.d0_lip ? p.section.lip : 0.0, lip_rate = patch.d0_lip ? p.section.lip_rate : 0.0;
    return Sample{patch.facing * (p.rho - p.section.foot - patch.d0 - lip),
                  patch.facing * (p.rho_rate - (p.section.foot_rate + lip_rate) * p.azimuth_rate)};
  };
  const double begin = patch.facing > 0.0 ? span.begin : std::max(span.begin, span.ray.closest());
  if (begin > span.end || gap(begin).gap <= 0.0) return kNever;
  const double bend = span.bends.foot + span.bends.lip + (patch.facing > 0.0 ? 0.0 : span.bends.rho);
  const double t = firstRoot(gap, bend, begin, span.end);
  if (t > span.end) return kNever;
  const TankPoint p = tank_.at(span.ray, t);
  const double rough = patch.rough ? noise_.at(p.position.x(), p.position.y()).value : 0.0;
  return p.h <= patch.h0 + rough + kTouch && p.h >= patch.bottom - noise_.bound() ? t : kNever;
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
  const double out = patch.riser ? 1.0 : patch.fall, up = patch.riser ? 0.0 : 1.0;
  const double turn = -(up * p.section.datum_rate + out * p.section.foot_rate) / p.rho;
  return tank_.worldNormal({out * cosine - turn * sine, out * sine + turn * cosine, up});
}

}  // namespace tank_datum::synth
