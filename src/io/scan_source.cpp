#include "io/scan_source.h"

#include <algorithm>
#include <utility>

#include "io/coordinates.h"
#include "io/record_rows.h"

namespace tank_datum {
namespace {

class ArraySource : public Scan::Source {
 public:
  ArraySource(std::uint64_t rows, Scan::Row row, RowNumbers numbers)
      : rows_(rows), row_(std::move(row)), numbers_(numbers) {}

  std::uint64_t size() const override { return rows_; }

  double coordinateStep(const Eigen::Vector3d& origin) const override {
    const RecordColumn column{0, {'F', 4}};
    return numbers_.single ? stepAt({column, column, column}, origin, numbers_.metres_per_unit) : 0.0;
  }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    ScanCounts counts;
    Points block;
    while (counts.points < rows_) {
      counts += fill(counts.points, {1.0, origin}, {}, block);
      if (!block.empty() && !visit(block, {})) break;
    }
    return counts;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    Points points, chosen;
    for (std::uint64_t begin = 0; begin < rows_; begin += kBlockRows, ++block) {
      const ScanCounts read = fill(begin, {1.0, origin}, {block % choice.n, choice.n}, points);
      chosen.clear();
      choice.choose(block, points, chosen);
      told(read, chosen, 0);
    }
  }

 private:
  /// Replaces points by the finite ones of the chosen rows of a block.
  ScanCounts fill(std::uint64_t begin, const Frame& frame, const RowChoice& rows, Points& points) const {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kBlockRows, rows_ - begin));
    ScanCounts counts{count, 0};
    points.clear();
    for (std::size_t i = 0, next = rows.first; i < count; ++i) {
      if (!appendFinite(row_(begin + i), frame, points)) {
        ++counts.invalid;
      } else if (i != next) {
        points.pop_back();
      }
      if (i == next) next += rows.step;
    }
    return counts;
  }

  std::uint64_t rows_;
  Scan::Row row_;
  RowNumbers numbers_;
};

}  // namespace

std::shared_ptr<const Scan::Source> arraySource(std::uint64_t rows, Scan::Row row, RowNumbers numbers) {
  return std::make_shared<ArraySource>(rows, std::move(row), numbers);
}

}  // namespace tank_datum
