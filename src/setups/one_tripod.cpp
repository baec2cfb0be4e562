#include "setups/one_tripod.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/portable_math.h"

namespace tank_datum {
namespace {

constexpr int kParameters = SetupMotion::kParameters;
using Covariance = Eigen::Matrix<double, kParameters, kParameters>;

/// Logarithm of how much likelier two parts' errors are those of one setup than those of two.
double oneOverTwo(const SetupAdjustment& adjusted, std::size_t a, std::size_t b) {
  const Eigen::Index i = static_cast<Eigen::Index>(a) * kParameters, j = static_cast<Eigen::Index>(b) * kParameters;
  const auto block = [&](Eigen::Index row, Eigen::Index column) -> Covariance {
    return adjusted.covariance.block<kParameters, kParameters>(row, column);
  };
  const Covariance after = block(i, i) + block(j, j) - block(i, j) - block(j, i);
  const SetupMotion::Vector difference =
      adjusted.errors.segment<kParameters>(i) - adjusted.errors.segment<kParameters>(j);
  const SetupSpread& spread = adjusted.spread;
  const auto own = [](double sigma) { return 2.0 * square(sigma); };
  const double before =
      portable::log(own(spread.height)) + 2.0 * portable::log(own(spread.tilt)) + 2.0 * portable::log(own(spread.plan));
  const Eigen::LDLT<Covariance> solver(after);
  const double known = solver.vectorD().array().max(0.0).unaryExpr([](double d) { return portable::log(d); }).sum();
  return 0.5 * (before - known - difference.dot(solver.solve(difference)));
}

}  // namespace

std::vector<std::uint16_t> setupsOfParts(const SetupAdjustment& adjusted) {
  constexpr double kByFar = 100.0;
  const std::size_t parts = adjusted.bad.size();
  const double pairs = 0.5 * static_cast<double>(parts * (parts - 1));
  const bool told = adjusted.height_estimated && adjusted.plan_estimated;
  std::vector<std::uint16_t> setups;
  std::vector<std::size_t> firsts;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto first = std::find_if(firsts.begin(), firsts.end(), [&](std::size_t f) {
      return told && oneOverTwo(adjusted, f, part) > portable::log(kByFar * pairs);
    });
    setups.push_back(static_cast<std::uint16_t>(first - firsts.begin()));
    if (first == firsts.end()) firsts.push_back(part);
  }
  return setups;
}

}  // namespace tank_datum
