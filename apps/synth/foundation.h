#pragma once

#include <vector>

#include "tank_shape.h"
#include "value_noise.h"

namespace tank_datum::synth {

/// What an edge of the profile keeps its distance from round the tank: the shell, the shell and the lip's varying
/// width, or the circle of the tank's radius.
enum class Edge { Shell, Lip, Circle };

/// Which height a piece of the profile counts from: the datum, the sloping plate, or the sector of the ringwall.
enum class Level { Datum, Plate, Sector };

/// A piece of the profile outside the shell, swept round the tank. Distances d are from the shell's foot radius
/// outwards, heights h from the datum. A band is a strip of slope `fall`; a riser a vertical face.
struct Patch {
  Surface surface;
  bool riser;
  double d0, d1;    ///< a band from d0 to d1; a riser at d0
  Edge at0, at1;    ///< what d0 and d1 count from
  double h0, fall;  ///< height at d0 and slope downwards outwards; a riser's top
  double bottom;    ///< of a riser
  double facing;    ///< 1: up or outwards, -1: down or inwards
  Level level;      ///< of h0; a riser's bottom counts from the datum
  bool rough;

  double height(double d) const { return riser ? h0 : h0 - fall * (d - d0); }
};

/// Earth against the shell, see options.
struct Heap {
  Soil options;
  double base;  ///< where the heap ends, below every surface it lies on [m]
  ValueNoise noise;
};

/// The stretch of a ray in which a patch may be met.
struct Span {
  const TankRay& ray;
  const RayBends& bends;
  double begin, end;

  /// Shortened to the part with z in low .. high; false when nothing is left.
  bool clipHeight(double low, double high);
  /// Shortened towards the part with rho in low .. high; false when nothing is left.
  bool clipRadius(double low, double high);
};

/// Everything swept round the shell foot: weld, pad, plate, ringwall, crown, slab, soil, and the rings on the shell.
class FoundationShape {
 public:
  /// @param depth  how far below the datum the ground may lie [m]; the outermost face goes down there
  FoundationShape(const TankShape& tank, double depth, std::uint64_t seed);

  void trace(const TankRay& local, int owner, Hit& hit) const;

  /// Height of the bare profile at distance d from the shell, without roughness, weld and soil [m].
  double profile(double d, double lip) const;
  /// Whether soil lies against the shell.
  bool buried(double azimuth) const;
  /// Height of the soil above the datum without its roughness; at most -0.05 below every surface where there is none.
  double soilHeight(const Heap& heap, double azimuth, double d) const;

  double maskWidth() const { return mask_width_; }  ///< the ground begins here, from the shell or the circle [m]
  double width() const { return width_; }           ///< outermost edge, from the shell [m]
  const ValueNoise& noise() const { return noise_; }
  const std::vector<Patch>& patches() const { return patches_; }
  const std::vector<Heap>& heaps() const { return heaps_; }

 private:
  void addProfile(double depth);
  void addRings();
  void addHeaps(std::uint64_t seed);
  Patch& band(Surface surface, double d0, double h0, double d1, double h1);
  Patch& riser(Surface surface, double d, double top, double bottom, double facing);
  void addPlate();
  void addRingwall(double depth);
  void addCrown(double depth);
  Sample edgeOf(Edge edge, double d, const TankPoint& p) const;
  Sample levelOf(const Patch& patch, double d, double d_rate, const TankPoint& p) const;
  double levelBound(const Patch& patch) const;
  bool clip(const Patch& patch, Span& span) const;
  double crossBand(const Patch& patch, const Span& span) const;
  double crossRiser(const Patch& patch, const Span& span) const;
  double crossHeap(const Heap& heap, const Span& span) const;
  Eigen::Vector3d normal(const Patch& patch, const TankPoint& p) const;

  const TankShape& tank_;
  ValueNoise noise_;
  std::vector<Patch> patches_;
  std::vector<Heap> heaps_;
  double mask_width_ = 0.0, width_ = 0.0;
};

}  // namespace tank_datum::synth
