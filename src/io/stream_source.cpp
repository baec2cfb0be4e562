#include <algorithm>
#include <utility>

#include "io/block_source.h"
#include "io/coordinates.h"
#include "io/scan_source.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

/// Blocks of any size are handed on in blocks of kBlockRows, so that memory beside them is that of one.
class BlockStream : public Scan::Source {
 public:
  explicit BlockStream(ScanBlocks blocks) : blocks_(std::move(blocks)), size_(blocks_.size) {
    if (!blocks_.start) throw Error(Error::Kind::Option, "io", "start of the blocks", "none", "a function");
    if (size_ == 0) size_ = countPoints();
  }

  std::uint64_t size() const override { return size_; }

  double coordinateStep(const Eigen::Vector3d&) const override { return blocks_.coordinate_step; }

  std::string labelField() const override { return blocks_.tells_setups ? "setup" : ""; }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    ScanCounts counts;
    ScanBlocks::Block block;
    Points points;
    Labels labels;
    const ScanBlocks::Next next = blocks_.start();
    while (next(block)) {
      for (std::size_t begin = 0; begin < block.points.size(); begin += kBlockRows) {
        const std::size_t rows = std::min(kBlockRows, block.points.size() - begin);
        points.clear();
        for (std::size_t i = begin; i < begin + rows; ++i) appendFinite(block.points[i], {1.0, origin}, points);
        counts += {rows, rows - points.size()};
        if (blocks_.tells_setups) labels.assign(points.size(), block.setup);
        if (!points.empty() && !visit(points, labels)) return counts;
      }
    }
    return counts;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    chooseInOrder(*this, origin, choice, block, told);
  }

 private:
  std::uint64_t countPoints() const {
    std::uint64_t points = 0;
    ScanBlocks::Block block;
    const ScanBlocks::Next next = blocks_.start();
    while (next(block)) points += block.points.size();
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
