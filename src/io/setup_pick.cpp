#include "io/setup_pick.h"

#include <algorithm>
#include <set>
#include <utility>

#include "io/block_source.h"

namespace tank_datum {
namespace {

class PickedSource : public Scan::Source {
 public:
  PickedSource(std::shared_ptr<const Scan::Source> source, std::vector<std::uint32_t> wanted)
      : source_(std::move(source)), wanted_(std::move(wanted)) {}

  std::uint64_t size() const override { return source_->size(); }
  double coordinateStep(const Eigen::Vector3d& origin) const override {
    return wanted_.empty() ? 0.0 : source_->coordinateStep(origin);
  }
  std::string labelField() const override { return source_->labelField(); }
  std::string labelName(std::uint32_t label) const override { return source_->labelName(label); }
  std::optional<Eigen::Vector3d> viewpoint(std::uint32_t label) const override { return source_->viewpoint(label); }
  std::vector<std::uint32_t> labels() const override { return wanted_; }

  ScanCounts visit(const Eigen::Vector3d& origin, const BlockVisitor& visit) const override {
    if (wanted_.empty()) return {size(), 0, size()};  // nothing of the file is read
    std::uint64_t left_out = 0;
    Points kept;
    Labels labels;
    ScanCounts counts = source_->visit(origin, [&](const Points& points, const Labels& of_points) {
      kept.clear();
      labels.clear();
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::binary_search(wanted_.begin(), wanted_.end(), of_points[i])) continue;
        kept.push_back(points[i]);
        labels.push_back(of_points[i]);
      }
      left_out += points.size() - kept.size();
      return kept.empty() || visit(kept, labels);
    });
    counts.left_out += left_out;
    return counts;
  }

  void choose(const Eigen::Vector3d& origin, const Choice& choice, int, std::uint64_t& block,
              const ChosenVisitor& told) const override {
    chooseInOrder(*this, origin, choice, block, told);
  }

 private:
  std::shared_ptr<const Scan::Source> source_;
  std::vector<std::uint32_t> wanted_;  ///< sorted; none, or some of a source with labels
};

}  // namespace

std::vector<std::uint32_t> labelsIn(const Scan::Source& source) {
  std::vector<std::uint32_t> known = source.labels();
  if (!known.empty()) return known;
  if (source.labelField().empty()) return {0};
  std::set<std::uint32_t> found;
  std::uint64_t block = 0;
  const Scan::Chooser first = [](std::uint64_t, const Points& points, Points& chosen) {
    if (!points.empty()) chosen.push_back(points.front());
  };
  source.choose(Eigen::Vector3d::Zero(), {first, 1}, 0, block,
                [&found](const ScanCounts&, const Points& chosen, std::uint32_t label) {
                  if (!chosen.empty()) found.insert(label);
                });
  return {found.begin(), found.end()};
}

std::shared_ptr<const Scan::Source> pickedSource(std::shared_ptr<const Scan::Source> source,
                                                 std::vector<std::uint32_t> wanted) {
  if (auto passing_over = source->ofLabels(wanted)) source = std::move(passing_over);
  return std::make_shared<PickedSource>(std::move(source), std::move(wanted));
}

}  // namespace tank_datum
