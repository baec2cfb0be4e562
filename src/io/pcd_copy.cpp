#include "io/pcd_copy.h"

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "io/pcd_writer.h"

namespace tank_datum {
namespace {

/// The number that each setup has in the copy. Their order stays; of a single file so do the labels.
class SetupNumbers {
 public:
  explicit SetupNumbers(const std::vector<SetupKey>& setups) : of_file_(setups.empty() ? 0 : setups.back().source + 1) {
    for (std::size_t i = 0; i < setups.size(); ++i) {
      const auto [source, label] = setups[i];
      of_file_[source][label] = of_file_.size() > 1 ? static_cast<std::uint32_t>(i) : label;
    }
  }

  std::uint32_t of(SetupKey setup) const { return of_file_[setup.source].at(setup.label); }

 private:
  std::vector<std::map<std::uint32_t, std::uint32_t>> of_file_;
};

/// @param plain  the scan relative to zero
PcdNotes notesOf(const Scan& plain, const std::vector<SetupKey>& setups, const SetupNumbers& numbers) {
  PcdNotes notes;
  for (const SetupKey setup : setups) {
    const std::uint32_t number = numbers.of(setup);
    const ScanBlocks::Setup known{plain.setupName(setup), plain.setupOrigin(setup)};
    if (known.viewpoint || known.name != std::to_string(number)) notes.setups[number] = known;
  }
  return notes;
}

/// Appends a block's rows to those of the copy.
class RowMaker {
 public:
  RowMaker(const Scan& scan, const SetupNumbers& numbers, const Eigen::Vector3d& from, const PcdCopy& copy)
      : scan_origin_(scan.origin()), numbers_(numbers), from_(from), copy_(copy) {}

  /// The rows of the block's points that are wanted; nothing when one of these does not come back to the last bit.
  const std::vector<double>* rowsOf(const Points& block, std::uint32_t source,
                                    const std::vector<std::uint32_t>& labels) {
    rows_.clear();
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Eigen::Vector3d& point = block[i];
      if (copy_.wanted && !copy_.wanted(point - scan_origin_)) continue;
      const Eigen::Vector3d stored = point - from_;
      if (stored + from_ != point) return nullptr;
      rows_.insert(rows_.end(), stored.data(), stored.data() + 3);
      rows_.push_back(numberOf({source, labels.empty() ? 0 : labels[i]}));
    }
    return &rows_;
  }

 private:
  /// Points of one setup mostly follow each other.
  double numberOf(SetupKey setup) {
    if (!(setup == last_)) {
      last_ = setup;
      number_ = numbers_.of(setup);
    }
    return number_;
  }

  Eigen::Vector3d scan_origin_;
  const SetupNumbers& numbers_;
  Eigen::Vector3d from_;
  const PcdCopy& copy_;
  SetupKey last_{SetupKey::kUnlabelled, SetupKey::kUnlabelled};  // none
  double number_ = 0.0;
  std::vector<double> rows_;
};

/// Fills the file; nothing when the rows' origin does not suit all points, and the points copied else.
std::optional<std::uint64_t> tryCopy(const Scan& plain, RowMaker rows, PcdWriter& writer, const PcdCopy& copy) {
  constexpr std::size_t kColumns = 4;
  std::uint64_t copied = 0, seen = 0;
  bool suits = true;
  plain.forEachLabelled([&](const Points& block, std::uint32_t source, const std::vector<std::uint32_t>& labels) {
    const std::vector<double>* made = suits ? rows.rowsOf(block, source, labels) : nullptr;
    suits = made != nullptr;
    if (!suits) return;
    writer.append(*made);
    copied += made->size() / kColumns;
    seen += block.size();
    if (copy.progress) copy.progress(seen);
  });
  if (!suits) return std::nullopt;
  writer.commit();
  return copied;
}

}  // namespace

Eigen::Vector3d localOrigin(const Eigen::Vector3d& origin) {
  constexpr double kGrid = 100.0;                                                                           // [m]
  return origin.unaryExpr([](double coordinate) { return std::trunc(coordinate / kGrid) * kGrid + 0.0; });  // no -0
}

std::uint64_t copyToPcd(const Scan& scan, const std::string& path, const PcdCopy& copy) {
  const std::vector<PcdField> fields = {{"x", 'F', 8}, {"y", 'F', 8}, {"z", 'F', 8}, {"setup", 'U', 4}};
  const Scan plain = scan.relativeTo(Eigen::Vector3d::Zero());
  const std::vector<SetupKey> setups = plain.setups();
  const SetupNumbers numbers(setups);
  PcdHeading heading{copy.comment, {}, notesOf(plain, setups, numbers)};
  heading.notes.step = scan.coordinateStep();
  Eigen::Vector3d from = localOrigin(scan.origin());
  while (true) {
    Eigen::Vector3d::Map(heading.notes.origin.data()) = from;
    PcdWriter writer(path, fields, PcdWriter::Format::Binary, heading);
    if (const auto copied = tryCopy(plain, {scan, numbers, from, copy}, writer, copy)) return *copied;
    from.setZero();  // points near zero have finer steps than differences from a place far off
  }
}

}  // namespace tank_datum
