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
  std::size_t end = 0;  ///< of a wide surface: behind its last bin before an edge, or where it bends; upon a lip, none
  double falls = 0;     ///< by how much one may fall more from bin to bin, which says nothing [m]

  /// Whether sections show the same bins, mostly.
  bool isWhole() const { return 2 * shared > seen; }
  /// Whether a bin of a section can be compared.
  bool tells(const Section& section, std::size_t bin) const;
  /// How many of some can.
  std::size_t told(const Section& section, std::size_t from, std::size_t to) const;
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
  double value = 0.0;    ///< 0 where chance explains it; NaN where too little is seen to tell [m]
  double from = 0.0;     ///< of the reach
  bool of_part = false;  ///< of the foundation's, beyond what lies on it
};

/// A station's section among others.
class SectionSeen {
 public:
  /// @param all  the narrowest bins first; outlives this
  SectionSeen(const std::vector<RingSections>& all, std::size_t station);

  /// How far all of the section lies below, or the part that stands out most of what ends with the foundation: soil
  /// ends somewhere, and only beyond is the foundation seen. (What lies beyond its edge need not move with it.)
  /// @param least  that counts [m]
  Depth depth(double least) const;

  /// Whether it would show what lies farther from the shell than a share of the reach.
  bool shows(double from) const;

 private:
  const RingSections *narrowest_, *shown_;  ///< bins; the narrowest most of which it shows, of the foundation
  std::size_t station_;
};

}  // namespace tank_datum
