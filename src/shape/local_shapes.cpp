#include "shape/local_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portable_math.h"
#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kWide = 3.0;  ///< standard deviation of a shape's height over the likeliest height

double apart(double a, double b) { return std::abs(std::remainder(a - b, kTwoPi)); }

CandidateShape candidate(const LocalShape& shape, const Eigen::VectorXd& azimuths) {
  CandidateShape result{shape, {}, {}};
  for (Eigen::Index i = 0; i < azimuths.size(); ++i) {
    if (apart(azimuths[i], shape.centre) >= shape.half_width) continue;
    result.stations.push_back(i);
    result.values.push_back(shape.at(azimuths[i]));
  }
  return result;
}

/// How much less the sum of squares is with a shape, and its likeliest height.
struct Gain {
  double squares = 0.0, height = 0.0;
};

Gain gainOf(const CandidateShape& candidate, const RingResiduals& left) {
  Eigen::VectorXd of_unknowns = Eigen::VectorXd::Zero(left.design.cols());
  double score = 0.0, information = 0.0;
  for (std::size_t k = 0; k < candidate.stations.size(); ++k) {
    const Eigen::Index i = candidate.stations[k];
    const double x = candidate.values[k], weighted = left.weights[i] * x;
    score += weighted * left.residuals[i];
    information += weighted * x;
    of_unknowns += weighted * left.design.row(i).transpose();
  }
  const double alone = information - left.precision.matrixL().solve(of_unknowns).squaredNorm();
  constexpr double kLeastPart = 1e-6;  // of a shape that the model cannot make itself
  return alone > kLeastPart * information ? Gain{score * score / alone, score / alone} : Gain{};
}

}  // namespace

double LocalShape::at(double azimuth) const {
  const double d = apart(azimuth, centre);
  return d < half_width ? 0.5 * (1.0 + portable::cos(kPi * d / half_width)) : 0.0;
}

Eigen::VectorXd LocalShape::waves(int order) const {
  Eigen::VectorXd coefficients(2 * order + 1);
  coefficients[0] = half_width / kTwoPi;
  for (int n = 1; n <= order; ++n) {
    const double turns = n * half_width / kPi, rest = 1.0 - turns * turns;
    const double wave =
        std::abs(rest) < 1e-9 ? 0.5 * half_width / kPi : portable::sin(n * half_width) / (n * kPi * rest);
    coefficients[2 * n - 1] = wave * portable::cos(n * centre);
    coefficients[2 * n] = wave * portable::sin(n * centre);
  }
  return coefficients;
}

bool LocalShape::isWithin(const LocalShape& other) const {
  return apart(centre, other.centre) < std::max(half_width, other.half_width);
}

LocalShape LocalShape::joinedWith(const LocalShape& other) const {
  const double offset = std::remainder(other.centre - centre, kTwoPi);
  const double from = std::min(-half_width, offset - other.half_width);
  const double to = std::max(half_width, offset + other.half_width);
  return {centre + 0.5 * (from + to), 0.5 * (to - from), std::max(scale, other.scale), false};
}

std::vector<CandidateShape> candidateShapes(const Eigen::VectorXd& azimuths, const Eigen::VectorXd& directions) {
  constexpr double kWidest = 30.0 * kPi / 180.0, kGrowth = 1.5, kNarrowest = 1.0 * kPi / 180.0;
  const double spacing = kTwoPi / static_cast<double>(azimuths.size());
  std::vector<std::pair<double, double>> places;  // direction, azimuth
  for (Eigen::Index i = 0; i < azimuths.size(); ++i) {
    const double direction = directions[i] + (directions[i] < 0.0 ? kTwoPi : 0.0);
    places.emplace_back(direction, azimuths[i] + (azimuths[i] < 0.0 ? kTwoPi : 0.0));
  }
  std::sort(places.begin(), places.end());
  std::vector<CandidateShape> shapes;
  for (double half = std::max(spacing, kNarrowest); half <= kWidest; half *= kGrowth) {
    const double apart_by = std::max(spacing, half / 3.0);
    double last = -kTwoPi;
    for (const auto& [direction, azimuth] : places) {
      if (direction - last < 0.999 * apart_by) continue;
      shapes.push_back(candidate({azimuth, half, 1.0, false}, azimuths));
      last = direction;
    }
  }
  return shapes;
}

std::vector<LocalShape> withDetails(const LocalShape& shape, double spacing) {
  constexpr double kDeparture = 0.1;
  std::vector<LocalShape> shapes = {shape};
  const double half = 0.5 * shape.half_width, deviation = kDeparture / kWide * shape.scale;
  if (half < spacing) return shapes;
  for (const double offset : {-1.0, -0.5, 0.0, 0.5, 1.0})
    shapes.push_back({shape.centre + offset * shape.half_width, half, deviation, true});
  return shapes;
}

std::optional<LocalShape> likeliestShape(const RingResiduals& left, const std::vector<CandidateShape>& candidates) {
  constexpr double kByChance = 4.0;
  Gain most{kByChance, 0.0};
  std::optional<LocalShape> likeliest;
  for (const CandidateShape& candidate : candidates) {
    const Gain gain = gainOf(candidate, left);
    if (gain.squares <= most.squares) continue;
    most = gain;
    likeliest = LocalShape{candidate.shape.centre, candidate.shape.half_width, kWide * std::abs(gain.height), false};
  }
  return likeliest;
}

}  // namespace tank_datum
