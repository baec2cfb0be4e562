#include "io/pcd_source.h"

#include <utility>

#include "io/block_source.h"
#include "io/pcd_data.h"
#include "io/record_source.h"

namespace tank_datum {
namespace {

/// Where the scanner stood, in stored units; with labels there are several.
std::optional<Eigen::Vector3d> viewpointOf(const PcdHeader& header) {
  if (!header.viewpoint || header.label) return std::nullopt;
  return Eigen::Vector3d(header.viewpoint->data());
}

std::string labelFieldOf(const PcdHeader& header) { return header.label ? header.columns[*header.label].name : ""; }

/// An ascii or compressed file, which can only be read from its beginning.
class PcdSource : public Scan::Source {
 public:
  PcdSource(std::shared_ptr<const InputFile> file, PcdHeader header, double metres_per_unit)
      : file_(std::move(file)), header_(std::move(header)), metres_per_unit_(metres_per_unit) {}

  std::uint64_t size() const override { return header_.points; }

  double coordinateStep(const Eigen::Vector3d& origin) const override {
    if (header_.encoding == PcdEncoding::Ascii) return header_.notes.step * metres_per_unit_;  // 0: it has all digits
    return stepAt(xyzOf(header_), origin, metres_per_unit_);
  }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    const auto visit_all = header_.encoding == PcdEncoding::Ascii ? visitAscii : visitCompressed;
    return visit_all(*file_, header_, {metres_per_unit_, origin}, visit);
  }

  std::string labelField() const override { return labelFieldOf(header_); }

  std::string labelName(std::uint32_t label) const override {
    const auto known = header_.notes.setups.find(label);
    return known == header_.notes.setups.end() ? Scan::Source::labelName(label) : known->second.name;
  }

  std::optional<Eigen::Vector3d> viewpoint(std::uint32_t label) const override {
    const auto known = header_.notes.setups.find(label);
    const auto stored = known == header_.notes.setups.end() ? viewpointOf(header_) : known->second.viewpoint;
    if (!stored) return std::nullopt;
    return Eigen::Vector3d(*stored * metres_per_unit_);
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    chooseInOrder(*this, origin, choice, block, told);
  }

 private:
  std::shared_ptr<const InputFile> file_;  // stays open: every pass sees the same file
  PcdHeader header_;
  double metres_per_unit_;
};

}  // namespace

std::shared_ptr<const Scan::Source> pcdSource(std::shared_ptr<const InputFile> file, double metres_per_unit) {
  PcdHeader header = readPcdHeader(*file);
  if (header.encoding != PcdEncoding::Binary) {
    return std::make_shared<PcdSource>(std::move(file), std::move(header), metres_per_unit);
  }
  return recordSource(std::move(file), recordRowsOf(header), metres_per_unit,
                      {labelFieldOf(header), false, viewpointOf(header), header.notes.setups});
}

}  // namespace tank_datum
