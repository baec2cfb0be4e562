#include <algorithm>
#include <utility>

#include "io/block_source.h"
#include "io/coordinates.h"
#include "io/read_ahead.h"
#include "io/scan_source.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr std::uint64_t kPartsLookedAt = 400;  // a scanner's round is seen every few degrees, of several setups too

/// Blocks of any size are handed on in blocks of kBlockRows, as those of a file: what every n-th row is does not depend
/// on how they come.
class BlockStream : public Scan::Source {
 public:
  explicit BlockStream(ScanBlocks blocks) : blocks_(std::move(blocks)), size_(blocks_.size) {
    if (!blocks_.start) throw Error(Error::Kind::Option, "io", "start of the blocks", "none", "a function");
    if (size_ == 0) size_ = countPoints();
  }

  std::uint64_t size() const override { return size_; }

  double coordinateStep(const Eigen::Vector3d&) const override { return blocks_.coordinate_step; }

  std::string labelField() const override { return blocks_.tells_setups ? "setup" : ""; }

  std::string labelName(std::uint32_t label) const override {
    const auto known = blocks_.setups.find(label);
    return known == blocks_.setups.end() ? Scan::Source::labelName(label) : known->second.name;
  }

  std::optional<Eigen::Vector3d> viewpoint(std::uint32_t label) const override {
    const auto known = blocks_.setups.find(label);
    return known == blocks_.setups.end() ? std::nullopt : known->second.viewpoint;
  }

  std::vector<std::uint32_t> labels() const override {
    std::vector<std::uint32_t> all;
    if (!blocks_.tells_setups || !blocks_.start_some) return all;
    for (const auto& [label, setup] : blocks_.setups) all.push_back(label);
    return all;
  }

  std::shared_ptr<const Scan::Source> ofLabels(const std::vector<std::uint32_t>& wanted) const override {
    if (!blocks_.start_some) return nullptr;
    auto some = std::make_shared<BlockStream>(*this);
    some->blocks_.start = [start = blocks_.start_some, wanted] { return start(wanted); };
    return some;
  }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    ScanCounts counts;
    ScanBlocks::Block block;
    Points points;
    Labels labels;
    ReadAhead ahead(blocks_.start());
    while (ahead.take(block)) {
      const std::uint64_t rows = block.points.size();
      counts += {rows + block.invalid + block.left_out, block.invalid, block.left_out};
      for (std::size_t first = 0, next = 0; first < rows; first = next) {
        next = std::min<std::size_t>(rows, first + kBlockRows - points.size());
        counts.invalid += next - first - appendRows(block, {first, next}, origin, points, labels);
        if (points.size() < kBlockRows) continue;
        if (!visit(points, labels)) return counts;
        points.clear();
        labels.clear();
      }
    }
    if (!points.empty()) visit(points, labels);
    return counts;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    const std::uint64_t every = choice.of_parts ? std::min(choice.n, blocks_.parts / kPartsLookedAt) : 0;
    if (every < 2 || !blocks_.start_every) return chooseInOrder(*this, origin, choice, block, told);
    BlockStream some(*this);
    some.blocks_.start = [start = blocks_.start_every, every] { return start(every); };
    chooseInOrder(some, origin, {choice.choose, choice.n / every | 1U}, block, told);
  }

 private:
  struct RowRange {
    std::size_t first = 0, behind = 0;
  };

  /// Appends the finite ones of some rows, and their labels where the blocks tell them.
  /// @return how many these are
  std::size_t appendRows(const ScanBlocks::Block& block, RowRange rows, const Eigen::Vector3d& origin, Points& points,
                         Labels& labels) const {
    const std::size_t before = points.size();
    points.resize(before + rows.behind - rows.first);
    if (blocks_.tells_setups) labels.resize(points.size());
    std::size_t kept = before;
    for (std::size_t i = rows.first; i < rows.behind; ++i) {
      const Eigen::Vector3d p = block.points[i] - origin;
      points[kept] = p;
      if (blocks_.tells_setups) labels[kept] = block.setups.empty() ? block.setup : block.setups[i];
      // 0 times a finite number is 0, times anything else NaN; no branch
      kept += static_cast<std::size_t>(p.x() * 0.0 + p.y() * 0.0 + p.z() * 0.0 == 0.0);
    }
    points.resize(kept);
    if (blocks_.tells_setups) labels.resize(kept);
    return kept - before;
  }

  std::uint64_t countPoints() const {
    std::uint64_t points = 0;
    ScanBlocks::Block block;
    ReadAhead ahead(blocks_.start());
    while (ahead.take(block)) points += block.points.size() + block.invalid + block.left_out;
    return points;
  }

  ScanBlocks blocks_;
  std::uint64_t size_ = 0;
};

}  // namespace

std::shared_ptr<const Scan::Source> streamSource(ScanBlocks blocks) {
  return std::make_shared<BlockStream>(std::move(blocks));
}

}  // namespace tank_datum
