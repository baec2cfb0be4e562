#include <algorithm>
#include <cmath>

#include "foundation.h"

namespace tank_datum::synth {

FoundationShape::FoundationShape(const TankShape& tank, double depth, std::uint64_t seed)
    : tank_(tank),
      noise_(mixed({seed, 201}), tank.options().foundation.roughness, tank.options().foundation.roughness_length) {
  addProfile(depth);
  addHeaps(seed);
  addRings();
}

Patch& FoundationShape::band(Surface surface, double d0, double h0, double d1, double h1) {
  patches_.push_back(
      {surface, false, d0, d1, Edge::Shell, Edge::Shell, h0, (h0 - h1) / (d1 - d0), 0.0, 1.0, Level::Datum, true});
  width_ = std::max(width_, d1);
  return patches_.back();
}

Patch& FoundationShape::riser(Surface surface, double d, double top, double bottom, double facing) {
  patches_.push_back({surface, true, d, d, Edge::Shell, Edge::Shell, top, 0.0, bottom, facing, Level::Datum, true});
  return patches_.back();
}

/// The lip and its outer face.
void FoundationShape::addPlate() {
  const Foundation& f = tank_.options().foundation;
  Patch& lip = band(Surface::AnnularPlate, 0.0, 0.0, f.plate_width, 0.0);
  lip.at1 = Edge::Lip, lip.level = Level::Plate;
  Patch& face = riser(Surface::AnnularPlate, f.plate_width, 0.0, -f.plate_thickness, 1.0);
  face.at0 = face.at1 = Edge::Lip, face.level = Level::Plate;
  if (tank_.riseBound() > 0.0) face.bottom -= tank_.riseBound();
}

void FoundationShape::addRingwall(double depth) {
  const Foundation& f = tank_.options().foundation;
  const double top = -f.plate_thickness;
  const Edge outer = f.concentric ? Edge::Circle : Edge::Shell;
  Patch& wall = band(Surface::Ringwall, f.plate_width, top, f.ringwall_width, top);
  wall.at0 = Edge::Lip, wall.at1 = outer, wall.level = Level::Sector;
  Patch& face = riser(Surface::Ringwall, f.ringwall_width, top, -depth, 1.0);
  face.at0 = face.at1 = outer, face.level = Level::Sector;
  if (tank_.riseBound() > f.plate_thickness) {  // where it stands higher than the plate it has a face inwards
    Patch& inner = riser(Surface::Ringwall, f.plate_width, top, top - tank_.riseBound(), -1.0);
    inner.at0 = inner.at1 = Edge::Lip, inner.level = Level::Sector;
  }
  mask_width_ = f.ringwall_width;
}

void FoundationShape::addCrown(double depth) {
  const Foundation& f = tank_.options().foundation;
  const double plate = -f.plate_thickness;
  const Edge edge = f.concentric ? Edge::Circle : Edge::Shell;
  const std::size_t first = patches_.size();
  band(Surface::Slab, f.plate_width, plate, f.crown_inner, plate).at0 = Edge::Lip;
  riser(Surface::Crown, f.crown_inner, f.crown_height, plate, -1.0);
  band(Surface::Crown, f.crown_inner, f.crown_height, f.crown_outer, f.crown_height);
  riser(Surface::Crown, f.crown_outer, f.crown_height, -f.slab_drop, 1.0);
  band(Surface::Slab, f.crown_outer, -f.slab_drop, f.slab_width, -f.slab_drop);
  riser(Surface::Slab, f.slab_width, -f.slab_drop, -depth, 1.0);
  for (std::size_t i = first; i < patches_.size(); ++i) {
    Patch& patch = patches_[i];
    if (patch.at0 == Edge::Shell) patch.at0 = edge;
    patch.at1 = edge, patch.level = Level::Sector;
    if (patch.riser && i + 1 < patches_.size()) patch.bottom -= tank_.riseBound();
  }
  mask_width_ = f.slab_width;
}

void FoundationShape::addProfile(double depth) {
  const Foundation& f = tank_.options().foundation;
  if (f.kind == "pad") {
    const double edge = -f.pad_fall * f.pad_width;
    band(Surface::Pad, 0.0, 0.0, f.pad_width, edge);
    band(Surface::Shoulder, f.pad_width, edge, f.pad_width + (depth + edge) / f.shoulder_fall, -depth);
    mask_width_ = f.pad_width;
  } else {
    addPlate();
    f.kind == "crown" ? addCrown(depth) : addRingwall(depth);
  }
  if (f.weld == 0.0) return;
  band(Surface::Weld, 0.0, f.weld, f.weld + noise_.bound(), -noise_.bound()).rough = false;
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
    const double shift = tank_.options().foundation.concentric ? tank_.footDeviation() : 0.0;
    for (int i = 0; i <= 1000; ++i) heap.base = std::min(heap.base, profile((soil.reach + shift) * i / 1000.0, 0.0));
    for (const Patch& patch : patches_) heap.base -= patch.riser ? 0.0 : levelBound(patch);
    heap.base -= 0.01 + heap.noise.bound() + noise_.bound();
    width_ = std::max(width_, soil.reach);
    heaps_.push_back(heap);
  }
}

double FoundationShape::profile(double d, double lip) const {
  double highest = -kNever;
  for (const Patch& p : patches_) {
    if (p.riser || p.surface == Surface::Weld || p.surface == Surface::Ring) continue;
    const bool here = d >= p.d0 + (p.at0 == Edge::Lip ? lip : 0.0) && d <= p.d1 + (p.at1 == Edge::Lip ? lip : 0.0);
    if (here) highest = std::max(highest, p.height(d));
  }
  return std::isinf(highest) ? 0.0 : highest;
}

}  // namespace tank_datum::synth
