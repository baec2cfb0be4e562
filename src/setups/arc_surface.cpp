#include "setups/arc_surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/statistics.h"

namespace tank_datum {
namespace {

constexpr std::size_t kFewestOfSetup = 12;  // points of a setup that make its offset worth looking at
constexpr std::size_t kFewestOfBin = 6;     // points of a bin that tell its scatter
constexpr std::size_t kFewestOfPart = 3;    // points of one setup in one bin that make a first median

std::size_t setupsIn(const std::vector<ArcPoint>& points) {
  std::vector<std::uint16_t> seen;
  for (const ArcPoint& p : points) {
    if (std::find(seen.begin(), seen.end(), p.setup) == seen.end()) seen.push_back(p.setup);
  }
  return seen.size();
}

/// Leaves out what lies off a bin's densest place, bins that one setup has to itself, and setups with few points.
ArcSurface sorted(const std::vector<ArcPoint>& points, double window) {
  std::map<std::uint16_t, ArcBin> bins;
  for (const ArcPoint& p : points) bins[p.bin].points.push_back(p);
  std::map<std::uint16_t, std::size_t> counts;
  for (auto at = bins.begin(); at != bins.end();) {
    std::vector<ArcPoint>& own = at->second.points;
    std::vector<double> values;
    for (const ArcPoint& p : own) values.push_back(p.value);
    std::sort(values.begin(), values.end());
    const double mode = halfSampleMode(values);
    own.erase(
        std::remove_if(own.begin(), own.end(), [&](const ArcPoint& p) { return std::abs(p.value - mode) > window; }),
        own.end());
    const bool shared = own.size() >= kFewestOfBin && setupsIn(own) > 1;
    if (shared) {
      for (const ArcPoint& p : own) ++counts[p.setup];
    }
    at = shared ? std::next(at) : bins.erase(at);
  }
  ArcSurface arc;
  std::map<std::uint16_t, std::uint16_t> index;
  for (const auto& [setup, count] : counts) {
    if (count < kFewestOfSetup) continue;
    index[setup] = static_cast<std::uint16_t>(arc.setups.size());
    arc.setups.push_back(setup);
  }
  for (auto& [number, bin] : bins) {
    ArcBin kept;
    for (ArcPoint p : bin.points) {
      const auto found = index.find(p.setup);
      if (found == index.end()) continue;
      p.setup = found->second;
      kept.points.push_back(p);
    }
    if (setupsIn(kept.points) > 1) arc.bins.push_back(std::move(kept));
  }
  return arc;
}

/// First offsets: medians of the differences between the setups' medians, bin by bin and part by part, from the setup
/// that most of them have.
void guessOffsets(ArcSurface& arc, std::size_t parts) {
  const std::size_t count = arc.setups.size(), fewest = parts > 1 ? 1 : kFewestOfPart;
  std::vector<std::vector<double>> medians(arc.bins.size() * parts, std::vector<double>(count, std::nan("")));
  std::vector<std::size_t> has(count, 0);
  for (std::size_t b = 0; b < arc.bins.size(); ++b) {
    std::vector<std::vector<double>> values(count * parts);
    for (const ArcPoint& p : arc.bins[b].points) values[p.part * count + p.setup].push_back(p.value);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i].size() < fewest) continue;
      medians[b * parts + i / count][i % count] = median(values[i]);
      ++has[i % count];
    }
  }
  const auto first = static_cast<std::size_t>(std::max_element(has.begin(), has.end()) - has.begin());
  arc.offsets = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count));
  for (std::size_t s = 0; s < count; ++s) {
    std::vector<double> differences;
    for (const auto& row : medians) {
      if (std::isfinite(row[s] - row[first])) differences.push_back(row[s] - row[first]);
    }
    if (!differences.empty()) arc.offsets[static_cast<Eigen::Index>(s)] = median(differences);
  }
}

/// First heights of the bins, and what each of several parts lies off the others: medians of what is left.
void guessSurface(ArcSurface& arc, std::size_t parts) {
  const auto setMedians = [&arc] {
    for (ArcBin& bin : arc.bins) {
      std::vector<double> left;
      for (const ArcPoint& p : bin.points) left.push_back(arc.residual(bin, p));
      bin.height += median(left);
    }
  };
  setMedians();
  if (parts == 1) return;
  std::vector<std::vector<double>> left(parts);
  for (const ArcBin& bin : arc.bins) {
    for (const ArcPoint& p : bin.points) left[p.part].push_back(arc.residual(bin, p));
  }
  for (std::size_t k = 0; k < parts; ++k) {
    if (!left[k].empty()) arc.curves[ArcSurface::kOfPart * static_cast<Eigen::Index>(k) + 2] = median(left[k]);
  }
  setMedians();
}

}  // namespace

ArcSurface guessedSurface(const std::vector<ArcPoint>& points, const ArcPrior& prior) {
  ArcSurface arc = sorted(points, prior.window);
  if (arc.setups.size() < 2 || arc.bins.empty()) return arc;
  arc.curves = Eigen::VectorXd::Zero(ArcSurface::kOfPart * static_cast<Eigen::Index>(prior.parts));
  guessOffsets(arc, prior.parts);
  guessSurface(arc, prior.parts);
  return arc;
}

}  // namespace tank_datum
