#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "core/units.h"
#include "setups/setup_adjustment.h"

/// Setups round a tank and what their overlaps show, without a scan.
namespace tank_datum::made_overlaps {

struct Survey {
  std::vector<Eigen::Vector3d> origins;
  std::vector<ArcView> arcs;
  Eigen::VectorXd errors;  ///< five for each setup
};

struct Recipe {
  std::size_t setups = 6;
  double radius = 30.0, distance = 12.0;  ///< [m]
  double half_view = 44.0 * kPi / 180.0;  ///< of a setup along the shell [rad]
  double sigma_error = 0.002, sigma_tilt = 10.0 / 3600.0 * kPi / 180.0, sigma_plan = 0.002;
  double sigma_arc = 0.00015;  ///< of a setup's offset in an arc, as the arc says and as it is [m]
  double sigma_unsaid = 0.0;   ///< on top of that, not said by the arc [m]
};

inline bool sees(const Recipe& recipe, std::size_t setup, double azimuth) {
  const double at = kTwoPi * static_cast<double>(setup) / static_cast<double>(recipe.setups);
  return std::abs(std::remainder(azimuth - at, kTwoPi)) < recipe.half_view;
}

inline Eigen::Vector3d placeAt(const Recipe& recipe, double azimuth, double height) {
  return {recipe.radius * std::cos(azimuth), recipe.radius * std::sin(azimuth), height};
}

/// The views of all arcs for errors already set.
inline void look(const Recipe& recipe, Survey& survey, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  constexpr int kArcs = 144;
  survey.arcs.clear();
  for (int a = 0; a < 2 * kArcs; ++a) {
    const bool shell = a % 2 == 1;
    const double azimuth = (a / 2 + 0.5) * kTwoPi / kArcs;
    ArcView arc;
    arc.number = static_cast<std::size_t>(a / 2);
    arc.shell = shell;
    arc.azimuth = azimuth;
    for (std::size_t s = 0; s < recipe.setups; ++s) {
      if (sees(recipe, s, azimuth)) arc.seen.setups.push_back(s);
    }
    const auto count = static_cast<Eigen::Index>(arc.seen.setups.size());
    if (count < 2) continue;
    arc.motion.resize(count, SetupMotion::kParameters);
    arc.seen.offsets.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const std::size_t s = arc.seen.setups[static_cast<std::size_t>(i)];
      const Eigen::Vector3d arm = placeAt(recipe, azimuth, shell ? 0.3 : 0.0) - survey.origins[s];
      const double c = std::cos(azimuth), n = std::sin(azimuth);
      if (shell) {
        arc.motion.row(i) << 0.0, -c * arm.z(), -n * arm.z(), c, n;
      } else {
        arc.motion.row(i) << 1.0, arm.x(), arm.y(), 0.0, 0.0;
      }
      arc.seen.offsets[i] = arc.motion.row(i).dot(survey.errors.segment<5>(5 * static_cast<Eigen::Index>(s))) +
                            std::hypot(recipe.sigma_arc, recipe.sigma_unsaid) * normal(random);
    }
    arc.seen.offsets.array() -= arc.seen.offsets.mean();
    arc.seen.information = (Eigen::MatrixXd::Identity(count, count) -
                            Eigen::MatrixXd::Constant(count, count, 1.0 / static_cast<double>(count))) /
                           (recipe.sigma_arc * recipe.sigma_arc);
    survey.arcs.push_back(arc);
  }
}

inline Survey made(const Recipe& recipe, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Survey survey;
  survey.errors.resize(5 * static_cast<Eigen::Index>(recipe.setups));
  for (std::size_t s = 0; s < recipe.setups; ++s) {
    const double azimuth = kTwoPi * static_cast<double>(s) / static_cast<double>(recipe.setups);
    const double out = recipe.radius + recipe.distance;
    survey.origins.push_back({out * std::cos(azimuth), out * std::sin(azimuth), 1.7});
    survey.errors.segment<5>(5 * static_cast<Eigen::Index>(s)) << recipe.sigma_error * normal(random),
        recipe.sigma_tilt * normal(random), recipe.sigma_tilt * normal(random), recipe.sigma_plan * normal(random),
        recipe.sigma_plan * normal(random);
  }
  look(recipe, survey, random);
  return survey;
}

/// The derivatives of 360 stations' elevations by the setups' errors, each station shared equally by those that see it.
inline Eigen::MatrixXd derivatives(const Recipe& recipe, const Survey& survey) {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(360, survey.errors.size());
  for (int i = 0; i < 360; ++i) {
    const double azimuth = i * kTwoPi / 360.0;
    double seen = 0.0;
    for (std::size_t s = 0; s < recipe.setups; ++s) seen += sees(recipe, s, azimuth) ? 1.0 : 0.0;
    for (std::size_t s = 0; s < recipe.setups; ++s) {
      if (!sees(recipe, s, azimuth)) continue;
      const Eigen::Vector3d arm = placeAt(recipe, azimuth, 0.0) - survey.origins[s];
      all.block<1, 3>(i, 5 * static_cast<Eigen::Index>(s)) << 1.0 / seen, arm.x() / seen, arm.y() / seen;
    }
  }
  return all;
}

/// What is left of stations' elevations without the plane that fits them best.
inline Eigen::VectorXd withoutPlane(const Eigen::VectorXd& z) {
  Eigen::MatrixXd plane(z.size(), 3);
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    const double azimuth = static_cast<double>(i) * kTwoPi / static_cast<double>(z.size());
    plane.row(i) << 1.0, std::cos(azimuth), std::sin(azimuth);
  }
  return z - plane * plane.colPivHouseholderQr().solve(z);
}

}  // namespace tank_datum::made_overlaps
