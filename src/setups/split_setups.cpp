#include "setups/split_setups.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

/// Of each setup the number of its group, from 0 on in the order in which groups first appear.
template <typename GroupOf>
std::vector<std::uint16_t> numberGroups(const std::vector<SetupKey>& setups, const GroupOf& group_of) {
  std::map<decltype(group_of(SetupKey{})), std::uint16_t> numbers;
  std::vector<std::uint16_t> of;
  for (const SetupKey& setup : setups) {
    of.push_back(numbers.emplace(group_of(setup), static_cast<std::uint16_t>(numbers.size())).first->second);
  }
  return of;
}

std::size_t countOf(const std::vector<std::uint16_t>& groups) {
  return groups.empty() ? 0 : std::size_t{1} + *std::max_element(groups.begin(), groups.end());
}

/// What the setups of each group show of the shell.
std::vector<ShellArcs> sumOf(const std::vector<ShellArcs>& setups, const std::vector<std::uint16_t>& groups) {
  std::vector<ShellArcs> sums(countOf(groups), ShellArcs(SetupRing::kArcs, 0));
  for (std::size_t s = 0; s < setups.size(); ++s) {
    for (std::size_t arc = 0; arc < SetupRing::kArcs; ++arc) sums[groups[s]][arc] += setups[s][arc];
  }
  return sums;
}

double total(const ShellArcs& arcs) { return std::accumulate(arcs.begin(), arcs.end(), 0.0); }

/// How far what setups show of a shell is from shares of what they show together, by chi squared over what chance makes
/// of it; any distance where they show too little. Setups that stand elsewhere show it more densely elsewhere.
double overChance(const std::vector<ShellArcs>& setups) {
  constexpr double kFewest = 20.0;  // points of an arc that is seen
  const ShellArcs sum = sumOf(setups, std::vector<std::uint16_t>(setups.size(), 0)).front();
  const auto seen = std::count_if(sum.begin(), sum.end(), [](std::size_t points) { return points > 0; });
  if (total(sum) < kFewest * static_cast<double>(seen)) return HUGE_VAL;
  double squares = 0.0, freedom = 0.0;
  for (const ShellArcs& setup : setups) {
    const double share = total(setup) / total(sum);
    for (std::size_t arc = 0; arc < sum.size(); ++arc) {
      const double expected = share * static_cast<double>(sum[arc]);
      if (!(expected > 0.0)) continue;
      squares += square(static_cast<double>(setup[arc]) - expected) / expected;
      freedom += 1.0 - share;
    }
  }
  return freedom > 0.0 ? squares / freedom : 0.0;
}

/// Whether setups may be shares of one: by what they show of the shell, and by where files say that they stood.
bool mayBeShares(const std::vector<ShellArcs>& setups, const std::vector<std::optional<Eigen::Vector3d>>& origins) {
  constexpr double kChance = 2.0;
  for (const auto& a : origins) {
    for (const auto& b : origins) {
      if (a && b && (*a - *b).norm() > kTripodsApart) return false;
    }
  }
  return overChance(setups) < kChance;
}

/// By how many standard errors two setups differ in height where both see the foundation; 0 where they never do.
double heightsApart(const std::vector<ArcView>& views, std::size_t a, std::size_t b) {
  double weights = 0.0, sum = 0.0;
  for (const ArcView& view : views) {
    const std::vector<std::size_t>& setups = view.seen.setups;
    const auto i = std::find(setups.begin(), setups.end(), a) - setups.begin();
    const auto j = std::find(setups.begin(), setups.end(), b) - setups.begin();
    if (view.shell || std::max(i, j) == view.seen.offsets.size()) continue;
    const Eigen::MatrixXd covariance = view.seen.information.completeOrthogonalDecomposition().pseudoInverse();
    const double weight = 1.0 / (covariance(i, i) + covariance(j, j) - 2.0 * covariance(i, j));
    weights += weight, sum += weight * (view.seen.offsets[i] - view.seen.offsets[j]);
  }
  return weights > 0.0 ? std::abs(sum) / std::sqrt(weights) : 0.0;
}

/// Setups by what they show, and where they stood.
class Shown {
 public:
  Shown(const std::vector<ShellArcs>& arcs, const std::vector<SetupKey>& setups, const Scan& scan,
        const std::function<std::vector<ArcView>()>& views)
      : arcs_(arcs), look_(views) {
    for (const SetupKey& setup : setups) origins_.push_back(scan.setupOrigin(setup));
  }

  bool areTilesBy(const std::vector<std::uint16_t>& files) const { return areTiles(sumOf(arcs_, files)); }

  /// Whether each group's setups are shares of one.
  bool areSharesBy(const std::vector<std::uint16_t>& groups) const {
    for (std::uint16_t group = 0; group < countOf(groups); ++group) {
      std::vector<std::size_t> members;
      for (std::size_t s = 0; s < groups.size(); ++s) {
        if (groups[s] == group) members.push_back(s);
      }
      if (members.size() > 1 && !areShares(members)) return false;
    }
    return true;
  }

  /// Groups of setups that are shares of one, where they are dense enough.
  std::vector<std::uint16_t> groupsOfShares() const {
    std::vector<std::uint16_t> groups;
    std::vector<std::size_t> firsts;
    for (std::size_t s = 0; s < arcs_.size(); ++s) {
      const auto first = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t f) {
        return isDense(f) && isDense(s) && areShares({f, s});
      });
      groups.push_back(static_cast<std::uint16_t>(first - firsts.begin()));
      if (first == firsts.end()) firsts.push_back(s);
    }
    return groups;
  }

 private:
  bool areShares(const std::vector<std::size_t>& members) const {
    std::vector<ShellArcs> arcs;
    std::vector<std::optional<Eigen::Vector3d>> origins;
    for (const std::size_t s : members) arcs.push_back(arcs_[s]), origins.push_back(origins_[s]);
    return mayBeShares(arcs, origins) && areAtOneHeight(members);
  }

  bool areAtOneHeight(const std::vector<std::size_t>& members) const {
    constexpr double kSure = 5.0;  // standard errors
    if (!views_) views_ = look_();
    return std::all_of(members.begin() + 1, members.end(),
                       [&](std::size_t s) { return heightsApart(*views_, members.front(), s) < kSure; });
  }

  bool isDense(std::size_t setup) const {
    constexpr double kFewest = 4000.0;  // points on the shell
    return total(arcs_[setup]) > kFewest;
  }

  const std::vector<ShellArcs>& arcs_;
  std::vector<std::optional<Eigen::Vector3d>> origins_;
  std::function<std::vector<ArcView>()> look_;
  mutable std::optional<std::vector<ArcView>> views_;
};

/// Makes one setup of each group's, which has the key of its first.
void join(Ring& ring, const std::vector<std::uint16_t>& groups) {
  std::vector<SetupKey> joined(countOf(groups));
  for (std::size_t s = ring.setups.size(); s-- > 0;) joined[groups[s]] = ring.setups[s];
  for (std::uint16_t& setup : ring.point_setups) setup = groups[setup];
  ring.setups = std::move(joined);
}

}  // namespace

SplitSetups joinSplitSetups(Ring& ring, const std::vector<ShellArcs>& shown, const Scan& scan,
                            const std::function<std::vector<ArcView>()>& views) {
  const std::size_t setups = ring.setups.size();
  if (setups < 2) return SplitSetups::None;
  const auto files = numberGroups(ring.setups, [](SetupKey setup) { return setup.source; });
  const auto labels = numberGroups(ring.setups, [&](SetupKey setup) { return scan.setupLabel(setup); });
  const auto tells = [&](const std::vector<std::uint16_t>& groups) {
    return countOf(groups) > 1 && countOf(groups) < setups;
  };
  const Shown setups_shown(shown, ring.setups, scan, views);
  if (tells(files) && tells(labels) && (setups_shown.areTilesBy(files) || setups_shown.areSharesBy(labels))) {
    join(ring, labels);
    return SplitSetups::ByLabel;
  }
  const std::vector<std::uint16_t> shares = setups_shown.groupsOfShares();
  if (countOf(shares) == setups) return SplitSetups::None;
  join(ring, shares);
  return SplitSetups::ByDensity;
}

}  // namespace tank_datum
