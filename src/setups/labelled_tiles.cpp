#include "setups/labelled_tiles.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "setups/shell_arcs.h"

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

}  // namespace

bool joinLabelledTiles(Ring& ring, const SetupRing& polar, const Scan& scan, const Tank& tank) {
  const auto files = numberGroups(ring.setups, [](SetupKey setup) { return setup.source; });
  const auto labels = numberGroups(ring.setups, [&](SetupKey setup) { return scan.setupLabel(setup); });
  const std::size_t setups = ring.setups.size();
  if (countOf(files) < 2 || countOf(files) == setups) return false;    // no file holds two
  if (countOf(labels) < 2 || countOf(labels) == setups) return false;  // none is in two files
  const auto shown = shellArcsOfSetups(polar, tank, ring.reach, setups);
  if (!areTiles(sumOf(shown, files))) return false;
  std::vector<SetupKey> joined(countOf(labels));
  for (std::size_t s = setups; s-- > 0;) joined[labels[s]] = ring.setups[s];
  for (std::uint16_t& setup : ring.point_setups) setup = labels[setup];
  ring.setups = std::move(joined);
  return true;
}

}  // namespace tank_datum
