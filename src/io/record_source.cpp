#include "io/record_source.h"

#include <utility>

#include "io/block_source.h"
#include "io/input_file.h"

namespace tank_datum {
namespace {

class RecordSource : public BlockSource {
 public:
  RecordSource(std::shared_ptr<const InputFile> file, const RecordRows& records, double metres_per_unit,
               RecordSetups setups)
      : file_(std::move(file)), records_(records), metres_per_unit_(metres_per_unit), setups_(std::move(setups)) {}

  std::uint64_t size() const override { return records_.rows; }

  double coordinateStep(const Eigen::Vector3d& origin) const override {
    return stepAt(records_.xyz, origin, metres_per_unit_);
  }

  std::string labelField() const override { return setups_.label_field; }

  std::string labelName(std::uint32_t label) const override {
    const auto known = setups_.known.find(label);
    if (known != setups_.known.end()) return known->second.name;
    return label == 0 && setups_.zero_is_none ? "" : Scan::Source::labelName(label);
  }

  std::optional<Eigen::Vector3d> viewpoint(std::uint32_t label) const override {
    const auto known = setups_.known.find(label);
    const auto place = known == setups_.known.end() ? setups_.viewpoint : known->second.viewpoint;
    if (!place) return std::nullopt;
    return Eigen::Vector3d(*place * metres_per_unit_);
  }

 protected:
  std::uint64_t blockCount() const override { return recordBlockCount(records_); }

  ScanCounts decode(const Eigen::Vector3d& origin, const BlockRows& chosen, BlockBuffer& buffer) const override {
    return decodeRecordBlock(*file_, records_, {metres_per_unit_, origin}, chosen, buffer);
  }

 private:
  std::shared_ptr<const InputFile> file_;  // stays open: every pass sees the same file
  RecordRows records_;
  double metres_per_unit_;
  RecordSetups setups_;
};

}  // namespace

std::shared_ptr<const Scan::Source> recordSource(std::shared_ptr<const InputFile> file, const RecordRows& records,
                                                 double metres_per_unit, RecordSetups setups) {
  return std::make_shared<RecordSource>(std::move(file), records, metres_per_unit, std::move(setups));
}

}  // namespace tank_datum
