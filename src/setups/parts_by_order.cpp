#include "setups/parts_by_order.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/parts.h"
#include "setups/setup_ring.h"

namespace tank_datum {
namespace {

/// A point of the ring: where it is seen.
struct Seen {
  std::size_t arc;
  float z;  ///< [m]
};

/// Points of one arc that follow each other in the file.
struct Visit {
  std::size_t arc, first, last;
  std::vector<float> heights;
  std::size_t points() const { return heights.size(); }
};

/// A run of the file, and the arcs that are seen in it.
struct Part {
  std::size_t first, last;                             ///< of its points
  std::size_t first_arc, last_arc;                     ///< that it sees first and last
  std::array<std::size_t, SetupRing::kArcs> points{};  ///< of each arc
  bool sees(std::size_t arc) const { return points[arc % SetupRing::kArcs] > 0; }
  std::size_t size() const { return last - first; }
};

/// All visits, in the order of the file.
/// @param apart  points between two visits of an arc
std::vector<Visit> visitsOf(const std::vector<Seen>& points, std::size_t apart) {
  std::vector<Visit> visits;
  std::vector<std::size_t> open(SetupRing::kArcs, visits.max_size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t& at = open[points[i].arc];
    if (at >= visits.size() || i - visits[at].last > apart) {
      at = visits.size();
      visits.push_back({points[i].arc, i, i, {}});
    }
    visits[at].last = i;
    visits[at].heights.push_back(points[i].z);
  }
  return visits;
}

/// Over which height nine tenths of the values lie.
float spreadOf(std::vector<float> heights) {
  const auto at = [&](double share) {
    const auto place = heights.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(heights.size() - 1));
    std::nth_element(heights.begin(), place, heights.end());
    return *place;
  };
  return heights.empty() ? 0.0F : at(0.95) - at(0.05);
}

/// The visits of a scanner that turns: it sees an arc from its foot to its top. None where much of the points are in
/// visits of a slice of it, as in sorted clouds, and where arcs have too many visits.
std::vector<Visit> sweepsOf(std::vector<Visit> visits) {
  constexpr std::size_t kMostVisits = 12;    // of an arc: more are rows of one scan, not scans
  constexpr std::size_t kFewestPoints = 12;  // of a visit; fewer are strays
  constexpr float kSlice = 0.5F;             // of the height over which an arc is seen
  constexpr double kMostStrays = 0.2;        // of all points
  std::vector<std::vector<float>> heights(SetupRing::kArcs);
  std::vector<float> spreads;
  for (const Visit& v : visits) heights[v.arc].insert(heights[v.arc].end(), v.heights.begin(), v.heights.end());
  for (std::vector<float>& of_arc : heights) spreads.push_back(spreadOf(std::move(of_arc)));
  std::vector<Visit> sweeps;
  std::vector<std::size_t> number(SetupRing::kArcs, 0);
  std::size_t all = 0, kept = 0;
  for (Visit& v : visits) {
    all += v.points();
    if (v.points() < kFewestPoints || spreadOf(v.heights) < kSlice * spreads[v.arc]) continue;
    if (++number[v.arc] > kMostVisits) return {};
    kept += v.points();
    sweeps.push_back(std::move(v));
  }
  if (static_cast<double>(all - kept) > kMostStrays * static_cast<double>(all)) return {};
  return sweeps;
}

/// The number of the first of the visits that each belongs together with: those of arcs side by side that follow each
/// other in the file, and so on.
std::vector<std::size_t> chainsOf(const std::vector<Visit>& visits, std::size_t apart) {
  std::vector<std::size_t> first(visits.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  std::vector<std::vector<std::size_t>> of_arc(SetupRing::kArcs);
  for (std::size_t i = 0; i < visits.size(); ++i) of_arc[visits[i].arc].push_back(i);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    for (const std::size_t j : of_arc[(visits[i].arc + 1) % SetupRing::kArcs]) {
      const Visit &a = visits[i], &b = visits[j];
      if (a.first <= b.last + apart && b.first <= a.last + apart)
        first[std::max(root(i), root(j))] = std::min(root(i), root(j));
    }
  }
  for (std::size_t i = 0; i < visits.size(); ++i) first[i] = root(i);
  return first;
}

/// Whether arcs are seen one after the other: each for a short while of its part, not all the time as in rows.
bool areSwept(const std::vector<Visit>& visits, const std::vector<Part>& parts) {
  constexpr double kWhile =
      0.4;  // of all arcs' time in all parts; a sweep of 120 degrees has 0.03, and more at its ends
  double visited = 0.0, seen = 0.0;
  for (const Visit& v : visits) visited += static_cast<double>(v.last - v.first);
  for (const Part& part : parts) {
    const auto arcs = std::count_if(part.points.begin(), part.points.end(), [](std::size_t n) { return n > 0; });
    seen += static_cast<double>(part.size()) * static_cast<double>(arcs);
  }
  return visited < kWhile * seen;
}

/// Two parts as one, the second later in the file.
Part united(Part a, const Part& b) {
  if (b.last > a.last) a.last = b.last, a.last_arc = b.last_arc;
  for (std::size_t arc = 0; arc < SetupRing::kArcs; ++arc) a.points[arc] += b.points[arc];
  return a;
}

/// The chains as parts, in their order.
std::vector<Part> partsOf(const std::vector<Visit>& visits, const std::vector<std::size_t>& chains) {
  std::vector<Part> parts;
  std::vector<std::size_t> part_of(visits.size());
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit& v = visits[i];
    Part own{v.first, v.last, v.arc, v.arc};
    own.points[v.arc] = v.points();
    if (chains[i] == i) {
      part_of[i] = parts.size();
      parts.push_back(own);
    } else {
      Part& part = parts[part_of[chains[i]]];
      part = united(part, own);
    }
  }
  return parts;
}

/// Whether two parts see the same arcs, over more than what the end of one setup's sweep and its beginning may share.
bool overlap(const Part& a, const Part& b) {
  constexpr std::size_t kFewestArcs = 3;
  std::size_t run = 0;
  for (std::size_t i = 0; i < SetupRing::kArcs + kFewestArcs && run < kFewestArcs; ++i)
    run = a.sees(i) && b.sees(i) ? run + 1 : 0;
  return run >= kFewestArcs;
}

/// Over how many arcs two parts reach together, those between them with them.
std::size_t spanOf(const Part& a, const Part& b) {
  return SetupRing::spanOf([&](std::size_t arc) { return a.sees(arc) || b.sees(arc); });
}

std::size_t arcsBetween(std::size_t a, std::size_t b) {
  const std::size_t apart = a > b ? a - b : b - a;
  return std::min(apart, SetupRing::kArcs - apart);
}

/// Whether a part ends here in full view: where a setup sees a shell no further it grazes it, with few points.
bool endsInView(const Part& part, std::size_t arc, std::size_t most) {
  constexpr double kInView = 0.15;  // of the points where most are; within two arcs of a shell's edge there are 0.07
  const std::size_t here = std::max({part.points[(arc + SetupRing::kArcs - 1) % SetupRing::kArcs], part.points[arc],
                                     part.points[(arc + 1) % SetupRing::kArcs]});
  return static_cast<double>(here) > kInView * static_cast<double>(most);
}

/// Whether a part and the next are of one setup: its sweep began before the shell and ended there, or something hides
/// the shell for a while.
bool ofOneSetup(const Part& a, const Part& b) {
  constexpr std::size_t kSeam = 3, kHidden = 12;  // arcs
  if (overlap(a, b) || spanOf(a, b) > SetupRing::kArcs / 2) return false;
  const std::size_t most = std::max(*std::max_element(a.points.begin(), a.points.end()),
                                    *std::max_element(b.points.begin(), b.points.end()));
  const auto meet = [&](std::size_t of_a, std::size_t of_b, std::size_t within) {
    return arcsBetween(of_a, of_b) <= within && endsInView(a, of_a, most) && endsInView(b, of_b, most);
  };
  return meet(a.first_arc, b.last_arc, kSeam) || meet(a.last_arc, b.first_arc, kHidden);
}

/// The parts, those of one setup united: parts that the file mixes are of one too.
std::vector<Part> setupsOf(std::vector<Part> parts) {
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.first < b.first; });
  std::vector<Part> setups;
  for (const Part& part : parts) {
    if (setups.empty()) {
      setups.push_back(part);
      continue;
    }
    Part& before = setups.back();
    const std::size_t shared = before.last > part.first ? std::min(before.last, part.last) - part.first : 0;
    if (2 * shared > std::min(before.size(), part.size()) || ofOneSetup(before, part)) {
      before = united(before, part);
    } else {
      setups.push_back(part);
    }
  }
  return setups;
}

/// Whether some parts see the same arcs, and none more of a shell than one setup does, from outside never half of it.
bool areOfSetups(const std::vector<Part>& parts, Side side) {
  bool any = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (side == Side::Outside && spanOf(parts[i], parts[i]) > SetupRing::kMostOfOneSetup) return false;
    for (std::size_t j = 0; j < i && !any; ++j) any = overlap(parts[i], parts[j]);
  }
  return any;
}

}  // namespace

std::vector<std::size_t> partsByOrder(const Ring& ring, const Tank& tank, int threads) {
  constexpr std::size_t kLookedAt = 800'000;
  constexpr double kApart = 0.005;  // of all points between two visits of an arc
  const std::size_t every = ring.points.size() / kLookedAt + 1, count = (ring.points.size() + every - 1) / every;
  const auto points = concatenated(ofParts(count, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Seen> part;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d& p = ring.points[i * every];
      part.push_back({SetupRing::arcOf(p, tank.circle.center), static_cast<float>(p.z())});
    }
    return part;
  }));
  const auto apart = static_cast<std::size_t>(kApart * static_cast<double>(count));
  const std::vector<Visit> sweeps = sweepsOf(visitsOf(points, apart));
  const std::vector<Part> pieces = partsOf(sweeps, chainsOf(sweeps, apart));
  if (!areSwept(sweeps, pieces)) return {};
  const std::vector<Part> parts = setupsOf(pieces);
  if (!areOfSetups(parts, tank.side)) return {};
  std::vector<std::size_t> begins(1, 0);
  for (std::size_t i = 1; i < parts.size(); ++i) begins.push_back(every * (parts[i - 1].last + parts[i].first + 1) / 2);
  return begins;
}

}  // namespace tank_datum
