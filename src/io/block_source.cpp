#include "io/block_source.h"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace tank_datum {
namespace {

/// What is chosen of a block, label by label.
struct ChosenOfLabel {
  std::uint32_t label = 0;
  Points points;
};

/// Asks the chooser for a block: once, or once for each of its labels in rising order.
void chooseByLabel(const Scan::Chooser& choose, std::uint64_t block, const Points& points, const Labels& labels,
                   std::vector<ChosenOfLabel>& chosen) {
  Labels found;  // most blocks have one: look for another before all are sorted
  if (!labels.empty()) {
    const auto is_first = [first = labels.front()](std::uint32_t label) { return label == first; };
    found.assign(labels.begin(),
                 std::all_of(labels.begin(), labels.end(), is_first) ? labels.begin() + 1 : labels.end());
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  chosen.resize(std::max<std::size_t>(1, found.size()));
  if (found.size() < 2) {
    chosen.front().label = found.empty() ? 0 : found.front();
    chosen.front().points.clear();
    choose(block, points, chosen.front().points);
    return;
  }
  Points alike;
  for (std::size_t k = 0; k < found.size(); ++k) {
    alike.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (labels[i] == found[k]) alike.push_back(points[i]);
    }
    chosen[k].label = found[k];
    chosen[k].points.clear();
    choose(block, alike, chosen[k].points);
  }
}

/// Tells what was chosen of one block, its counts with the first.
void tell(const Scan::Source::ChosenVisitor& told, const ScanCounts& read, const std::vector<ChosenOfLabel>& chosen) {
  for (std::size_t k = 0; k < chosen.size(); ++k) told(k == 0 ? read : ScanCounts{}, chosen[k].points, chosen[k].label);
}

/// Blocks that are decoded together, to be told in their order.
struct Round {
  explicit Round(std::size_t most) : chosen(most), read(most) {}

  void tellOnce(const Scan::Source::ChosenVisitor& told) {
    const std::size_t untold = std::exchange(blocks, 0);
    for (std::size_t i = 0; i < untold; ++i) tell(told, read[i], chosen[i]);
  }

  std::vector<std::vector<ChosenOfLabel>> chosen;
  std::vector<ScanCounts> read;
  std::size_t blocks = 0;  // that were not told yet
};

}  // namespace

ScanCounts BlockSource::visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const {
  constexpr std::uint64_t kRound = 16;  // blocks decoded at once
  const std::uint64_t count = blockCount();
  ScanCounts counts;
  std::vector<BlockBuffer> buffers(kRound);
  std::vector<ScanCounts> read(kRound);
  for (std::uint64_t begin = 0, end = 0; begin < count; begin = end) {
    end = std::min(count, begin == 0 ? 1 : begin + kRound);  // the first alone: many look at no more
    forEachIndex(end - begin, 0, [&](std::size_t i) { read[i] = decode(origin, {begin + i}, buffers[i]); });
    for (std::size_t i = 0; i < end - begin; ++i) {
      counts += read[i];
      if (!buffers[i].points.empty() && !visit(buffers[i].points, buffers[i].labels)) return counts;
    }
  }
  return counts;
}

void BlockSource::choose(const Eigen::Vector3d& origin, const Choice& choice, int threads, std::uint64_t& block,
                         const ChosenVisitor& told) const {
  constexpr std::uint64_t kRound = 64;  // blocks; a million rows between two calls of told
  const std::uint64_t count = blockCount();
  Round now(kRound), before(kRound);
  const auto caller = std::this_thread::get_id();
  for (std::uint64_t begin = 0; begin < count; begin += kRound) {
    now.blocks = static_cast<std::size_t>(std::min(kRound, count - begin));
    forEachIndex(now.blocks, threads, [&](std::size_t i) {
      thread_local BlockBuffer buffer;
      // others decode on while the thread that asked is told of the round before
      if (std::this_thread::get_id() == caller) before.tellOnce(told);
      const std::uint64_t number = block + begin + i;
      now.read[i] = decode(origin, {begin + i, {number % choice.n, choice.n}}, buffer);
      chooseByLabel(choice.choose, number, buffer.points, buffer.labels, now.chosen[i]);
    });
    before.tellOnce(told);  // others may have taken all blocks
    std::swap(now, before);
  }
  before.tellOnce(told);
  block += count;
}

void chooseInOrder(const Scan::Source& source, const Eigen::Vector3d& origin, const Scan::Source::Choice& choice,
                   std::uint64_t& block, const Scan::Source::ChosenVisitor& told) {
  Points thinned;
  Labels labels;
  std::vector<ChosenOfLabel> chosen;
  std::uint64_t finite = 0;
  const ScanCounts all = source.visit(origin, [&](const Points& points, const Labels& of_points) {
    if (choice.n == 1) {
      chooseByLabel(choice.choose, block++, points, of_points, chosen);
    } else {
      thinned.clear();
      labels.clear();
      for (std::size_t i = block % choice.n; i < points.size(); i += choice.n) {
        thinned.push_back(points[i]);
        if (!of_points.empty()) labels.push_back(of_points[i]);
      }
      chooseByLabel(choice.choose, block++, thinned, labels, chosen);
    }
    finite += points.size();
    tell(told, {points.size(), 0}, chosen);
    return true;
  });
  told({all.points - finite, all.invalid, all.left_out}, {}, 0);
}

}  // namespace tank_datum
