#pragma once

#include <cstddef>
#include <vector>

#include "foot/foot_state.h"

namespace tank_datum {

/// Heights above the station's elevation against the distance from the shell, in bins alike to the end of the reach;
/// NaN where too few points lie [m].
using Section = std::vector<double>;

/// What sections show round the ring, bin by bin: their median, and how far they usually lie off it.
struct UsualSection {
  Section height, spread;
  std::size_t seen = 0, shared = 0;  ///< bins that a few sections show at least, and half of them

  /// Whether sections show the same bins, mostly.
  bool isWhole() const { return 2 * shared > seen; }
  /// Whether a bin of a section can be compared.
  bool tells(const Section& section, std::size_t bin) const;
  /// How many can, from one on.
  std::size_t told(const Section& section, std::size_t from = 0) const;
};

/// The sections of all stations in bins of one width, and what is usual among them.
struct RingSections {
  std::vector<Section> own;
  UsualSection usual;
};

/// What is seen beyond the surface that stations lie on, in bins as narrow as the scan's rows allow, and then wider:
/// where rows lie so far apart that one station shows a bin and the next does not, few show the same. Where no bins are
/// wide enough, the narrowest have to do.
/// @param surface  of the whole ring
/// @param levels   elevations of the stations that stand, NaN of others [m]
/// @param tells    which stations say what is usual
std::vector<RingSections> sectionsBeyond(const Foot& foot, const FootProfile& surface,
                                         const std::vector<double>& levels, const std::vector<bool>& tells);

/// How far a section lies below the usual one from somewhere on.
struct Depth {
  double value = 0.0;  ///< 0 where chance explains it; NaN where too little is seen to tell [m]
  double from = 0.0;   ///< of the reach
};

/// A station's section among others, in the narrowest bins most of which it shows; in the narrowest where it shows most
/// of none.
class SectionSeen {
 public:
  /// @param all  the narrowest bins first; outlives this
  SectionSeen(const std::vector<RingSections>& all, std::size_t station);

  /// The depth that stands out most of any part that reaches to the end: what lies on a foundation ends somewhere, and
  /// only beyond is the foundation seen.
  /// @param least  that counts [m]
  Depth depth(double least) const;

  /// Whether it would show what lies farther from the shell than a share of the reach.
  bool shows(double from) const;

 private:
  const Section* section_;
  const UsualSection* usual_;
};

}  // namespace tank_datum
