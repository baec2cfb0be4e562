#include "shell/sharp_steps.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "core/units.h"
#include "fit/ring_cells.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

constexpr double kNarrowest = 0.025, kWidest = 0.1;  // columns of points [m]: the scan may be coarse in places
constexpr std::size_t kParts = 4;                    // of a column, which may begin with any
constexpr std::size_t kGap = 2;                      // parts between the columns before a step and those beyond
constexpr std::size_t kFewestInColumn = 5;           // points of a column
constexpr std::size_t kBeside = 5;                   // columns looked at on either side of a step
constexpr double kLowest = 0.006;                    // step: setups disagree by less, plates are thicker [m]
constexpr double kErrors = 5.0;                      // standard errors
constexpr double kMiddle = 0.3, kOfMiddle = 1.049;   // quantile, and between both of the normal distribution
constexpr double kScattered = 3.0;                   // times the usual spread: points of two levels
constexpr double kBetter = 2.0;                      // times closer to two levels than to a parabola

/// A column of points of a row.
struct StepColumn {
  double radius = kUnknown;  ///< [m]; NaN of few points, or where they are of two levels
  std::size_t points = 0;
};

/// ColumnParts of columns, side by side: the radii of their points [m].
using ColumnParts = std::vector<std::vector<double>>;

/// The column that begins with a part.
StepColumn columnFrom(std::size_t part, const ColumnParts& parts, double noise) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < kParts; ++i) {
    const std::vector<double>& more = parts[(part + i) % parts.size()];
    radii.insert(radii.end(), more.begin(), more.end());
  }
  if (radii.size() < kFewestInColumn) return {kUnknown, radii.size()};
  const double spread = (quantile(radii, 1.0 - kMiddle) - quantile(radii, kMiddle)) / kOfMiddle;
  return {spread < kScattered * noise ? median(radii) : kUnknown, radii.size()};
}

/// The row in columns, one from every part on.
std::vector<StepColumn> columnsOf(const PolarRing& ring, std::size_t count, double noise) {
  ColumnParts parts(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto [from, to] = ring.inCell(k, count);
    for (std::size_t i = from; i < to; ++i) parts[k].push_back(ring.points()[i].radius);
  }
  std::vector<StepColumn> columns;
  for (std::size_t k = 0; k < count; ++k) columns.push_back(columnFrom(k, parts, noise));
  return columns;
}

/// What columns side by side show: two levels with a slope in common, or a parabola.
class StepModel {
 public:
  /// @param place  of the step, before that column
  /// @param gap    of parts that are left out there: a thick plate shows its edge
  StepModel(std::size_t columns, std::size_t place, std::size_t gap) : place_(place), gap_(gap) {
    const auto rows = static_cast<Eigen::Index>(columns), beyond = static_cast<Eigen::Index>(place);
    Eigen::MatrixX3d turn(rows, 3), step(rows, 3);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double t = static_cast<double>(partOf(static_cast<std::size_t>(i))) / kParts;
      turn.row(i) << 1.0, t, t * t;
      step.row(i) << 1.0, t, i < beyond ? -0.5 : 0.5;
    }
    const Eigen::MatrixXd to_step = (step.transpose() * step).inverse() * step.transpose();
    to_height_ = to_step.row(2);
    off_step_ = Eigen::MatrixXd::Identity(rows, rows) - step * to_step;
    off_turn_ = Eigen::MatrixXd::Identity(rows, rows) - turn * ((turn.transpose() * turn).inverse() * turn.transpose());
  }

  /// Height of the step between the two levels [m]; 0 where the radii turn rather, NaN where points are too few.
  /// @param columns  from every part on
  /// @param first    part
  double stepIn(const std::vector<StepColumn>& columns, std::size_t first, double noise) const {
    const auto column = [&](Eigen::Index i) -> const StepColumn& {
      return columns[(first + partOf(static_cast<std::size_t>(i))) % columns.size()];
    };
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    double height = 0.0;
    for (Eigen::Index i = 0; i < to_height_.size(); ++i) {
      if (column(i).points < kFewestInColumn) return kUnknown;
      fewest = std::min(fewest, column(i).points);
      height += to_height_[i] * column(i).radius;
    }
    const double of_a_column = kMedianOverMean * noise / std::sqrt(static_cast<double>(fewest));
    if (!(std::abs(height) >= std::max(kLowest, kErrors * of_a_column * to_height_.norm()))) return 0.0;
    Eigen::VectorXd radii(to_height_.size());
    for (Eigen::Index i = 0; i < radii.size(); ++i) radii[i] = column(i).radius - column(0).radius;
    return kBetter * (off_step_ * radii).norm() < (off_turn_ * radii).norm() ? height : 0.0;
  }

 private:
  /// That a column begins with, from the first one's on.
  std::size_t partOf(std::size_t column) const { return column * kParts + (column < place_ ? 0 : gap_); }

  std::size_t place_, gap_;
  Eigen::VectorXd to_height_;
  Eigen::MatrixXd off_step_, off_turn_;
};

bool isFound(double height) { return std::abs(height) > 0.0; }

/// Whether nothing is found just before a part.
bool isNoneBefore(const std::vector<double>& heights, std::size_t k, std::size_t near) {
  for (std::size_t i = 1; i <= near; ++i) {
    if (isFound(heights[(k + heights.size() - i) % heights.size()])) return false;
  }
  return true;
}

/// Steps from what is found at the parts: each is found a little before it and beyond it as well.
/// @param heights  at the beginning of every part [m], 0 where there is none, NaN where that is not known
std::vector<SharpStep> stepsOf(const std::vector<double>& heights) {
  constexpr std::size_t kNear = kParts * kBeside / 2;
  const std::size_t count = heights.size();
  std::size_t start = 0;
  while (start < count && !isNoneBefore(heights, start, kNear)) ++start;
  std::vector<SharpStep> steps;
  std::size_t first = 0, last = 0;  // where the step is found
  for (std::size_t k = start; k < start + count && start < count; ++k) {
    const double height = heights[k % count];
    if (!isFound(height)) continue;
    const bool goes_on = !steps.empty() && k - last <= kNear && height * steps.back().height > 0.0;
    if (!goes_on) first = k, steps.push_back({0.0, height});
    last = k;
    SharpStep& step = steps.back();
    step.azimuth = kTwoPi * 0.5 * static_cast<double>(first + last + kGap) / static_cast<double>(count);
    if (std::abs(height) > std::abs(step.height)) step.height = height;
  }
  return steps;
}

}  // namespace

std::vector<SharpStep> sharpSteps(const PolarRing& ring, double radius, double noise) {
  const StepModel model(2 * kBeside, kBeside, kGap);
  constexpr std::size_t kBefore = kBeside * kParts;
  std::vector<SharpStep> steps;
  std::vector<double> narrower;  // heights of steps as narrower columns show them
  for (double width = kNarrowest; width <= kWidest; width *= 2.0) {
    const auto count = static_cast<std::size_t>(std::ceil(kTwoPi * radius / width * kParts));
    if (count < 3 * kBefore) break;
    if (count > kParts * ring.points().size()) continue;  // however large a tank is
    const std::vector<StepColumn> columns = columnsOf(ring, count, noise);
    std::vector<double> heights(count);
    for (std::size_t k = 0; k < count; ++k) heights[k] = model.stepIn(columns, (k + count - kBefore) % count, noise);
    for (const SharpStep& step : stepsOf(heights)) {
      if (narrower.empty() || std::isnan(narrower[ringCell(step.azimuth, narrower.size())])) steps.push_back(step);
    }
    narrower = std::move(heights);
  }
  return steps;
}

bool stepsUpwards(const PolarRing& ring, const RowPlace& place, double noise) {
  static constexpr std::size_t kLayers = 8, kLeast = 2;  // of them on either side of a step
  static const std::vector<StepModel> models = [] {
    std::vector<StepModel> all;
    for (std::size_t place = kLeast; place + kLeast <= kLayers; ++place) all.push_back({kLayers, place, 0});
    return all;
  }();
  ColumnParts parts((kLayers + 1) * kParts - 1);
  ring.around(place.azimuth, place.half_width, [&](const PolarPoint& p, double) {
    const double share = (p.z - place.z) / (2.0 * place.half_band) + 0.5;
    if (share >= 0.0 && share < 1.0)
      parts[static_cast<std::size_t>(share * static_cast<double>(parts.size()))].push_back(p.radius);
  });
  std::vector<StepColumn> layers;
  for (std::size_t k = 0; k < parts.size(); ++k) layers.push_back(columnFrom(k, parts, noise));
  for (const StepModel& model : models) {
    for (std::size_t first = 0; first < kParts; ++first) {
      if (isFound(model.stepIn(layers, first, noise))) return true;
    }
  }
  return false;
}

}  // namespace tank_datum
