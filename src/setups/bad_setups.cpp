#include "setups/bad_setups.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/statistics.h"

namespace tank_datum {
namespace {

/// The overlaps and what counts as far off in them.
struct Survey {
  const Overlaps& overlaps;
  const KindSigmas& usual;
  const BadSetupBounds& bounds;
};

/// How far a setup lies beyond what its sigmas allow, the setup freed of its priors: the larger of two squares over
/// their bounds, for its height and tilts and for its place. Beyond 1 it is bad.
double beyond(const SetupSolution& freed, std::size_t setup, const KindSigmas& sigmas, const BadSetupBounds& bounds,
              double others) {
  const Eigen::Index at = static_cast<Eigen::Index>(setup) * SetupMotion::kParameters;
  Eigen::MatrixXd spread = freed.covariance.block<SetupMotion::kParameters, SetupMotion::kParameters>(at, at);
  for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) spread(i, i) += sigmas[kindOf(i)] * sigmas[kindOf(i)];
  const SetupMotion::Vector error = freed.errors.segment<SetupMotion::kParameters>(at);
  const Eigen::Vector3d upright = error.head<3>();
  const Eigen::Vector2d place = error.tail<2>();
  return std::max(upright.dot(spread.topLeftCorner<3, 3>().ldlt().solve(upright)) / bounds.of(3.0, others),
                  place.dot(spread.bottomRightCorner<2, 2>().ldlt().solve(place)) / bounds.of(2.0, others));
}

/// Sigmas of the setups that are not freed (one step of expectation and maximisation), drawn towards the usual ones by
/// so many setups' worth.
KindSigmas sigmasOfOthers(const SetupSolution& solution, const KindSigmas& usual, const std::vector<bool>& freed,
                          double usual_worth) {
  KindSigmas squares{}, counts{}, sigmas{};
  for (Eigen::Index i = 0; i < solution.errors.size(); ++i) {
    if (freed[static_cast<std::size_t>(i / SetupMotion::kParameters)]) continue;
    squares[kindOf(i)] += solution.errors[i] * solution.errors[i] + solution.covariance(i, i);
    counts[kindOf(i)] += 1.0;
  }
  for (std::size_t k = 0; k < kParameterKinds; ++k) {
    const double worth = usual_worth * (k == 0 ? 1.0 : 2.0);
    sigmas[k] = std::sqrt((squares[k] + worth * usual[k] * usual[k]) / (counts[k] + worth));
  }
  return sigmas;
}

/// A setup by itself, its own error kept out of the others' sigmas.
struct Suspect {
  std::size_t setup = 0;
  KindSigmas sigmas{};     ///< of the others
  Eigen::VectorXd priors;  ///< by these, its own lifted
  double others = 0.0;     ///< how many they are
  double beyond = 0.0;     ///< how far it is beyond what its sigmas allow: 1 is at the bound
};

double beyondIn(const SetupSystem& system, const Suspect& suspect, const BadSetupBounds& bounds) {
  return beyond(solveSetups(system, suspect.priors), suspect.setup, suspect.sigmas, bounds, suspect.others);
}

Suspect suspectOf(const Survey& survey, const SetupSystem& system, std::vector<bool> freed, std::size_t setup) {
  freed[setup] = true;
  Suspect suspect;
  suspect.setup = setup;
  suspect.sigmas = survey.usual;
  for (int pass = 0; pass < 2; ++pass) {
    suspect.sigmas = sigmasOfOthers(solveSetups(system, priorSigmas(suspect.sigmas, freed)), survey.usual, freed,
                                    survey.bounds.usual_worth);
  }
  suspect.priors = priorSigmas(suspect.sigmas, freed);
  suspect.others = static_cast<double>(std::count(freed.begin(), freed.end(), false));
  suspect.beyond = beyondIn(system, suspect, survey.bounds);
  return suspect;
}

/// How far it is beyond without any one of the places at which it is seen, down to the bound.
double beyondElsewhere(const Survey& survey, const Suspect& suspect) {
  double least = suspect.beyond;
  for (const double azimuth : survey.overlaps.placesOf(suspect.setup)) {
    if (!(least > 1.0)) break;
    least = std::min(least, beyondIn(survey.overlaps.systemWithout(azimuth), suspect, survey.bounds));
  }
  return least;
}

/// The setup furthest off of those that are so without any one place. Those with the largest errors are looked at.
Suspect worstSetup(const Survey& survey, const SetupSystem& system, const std::vector<bool>& freed) {
  constexpr std::size_t kLookedAt = 8;
  const SetupSolution solution = solveSetups(system, priorSigmas(survey.usual, freed));
  std::vector<std::pair<double, std::size_t>> largest;
  for (std::size_t s = 0; s < freed.size(); ++s) {
    double square = 0.0;
    for (Eigen::Index i = 0; i < SetupMotion::kParameters; ++i) {
      const double error = solution.errors[static_cast<Eigen::Index>(s) * SetupMotion::kParameters + i];
      square += error * error / (survey.usual[kindOf(i)] * survey.usual[kindOf(i)]);
    }
    if (!freed[s]) largest.emplace_back(-square, s);
  }
  std::sort(largest.begin(), largest.end());
  largest.resize(std::min(largest.size(), kLookedAt));
  std::vector<Suspect> suspects;
  for (const auto& one : largest) suspects.push_back(suspectOf(survey, system, freed, one.second));
  std::sort(suspects.begin(), suspects.end(), [](const Suspect& a, const Suspect& b) { return a.beyond > b.beyond; });
  for (Suspect& suspect : suspects) {
    suspect.beyond = beyondElsewhere(survey, suspect);
    if (suspect.beyond > 1.0) return suspect;
  }
  return {};
}

}  // namespace

double BadSetupBounds::of(double parameters, double others) const {
  constexpr double kDeviate = 2.748;  // of the normal distribution at 0.3 %
  if (!estimates) return chiSquareQuantile(parameters, kDeviate);
  return parameters * fQuantile(parameters, 2.0 * (others + usual_worth), kDeviate);  // a setup has two tilts
}

std::size_t mostBad(std::size_t setups) {
  constexpr std::size_t kOneIn = 5;
  return std::max<std::size_t>(1, setups / kOneIn);
}

std::vector<bool> badSetups(const Overlaps& overlaps, const KindSigmas& usual, const BadSetupBounds& bounds) {
  constexpr std::size_t kFewestSetups = 3;
  constexpr double kNearly = 0.5;
  const Survey survey{overlaps, usual, bounds};
  const SetupSystem system = overlaps.system();
  const std::size_t setups = overlaps.setups(), most = mostBad(setups);
  std::vector<bool> bad(setups, false);
  double last = 0.0;
  for (std::size_t found = 0; setups >= kFewestSetups; ++found) {
    const Suspect worst = worstSetup(survey, system, bad);
    if (!(worst.beyond > 1.0)) break;
    if (found == most) return worst.beyond > kNearly * last ? std::vector<bool>(setups, false) : bad;
    bad[worst.setup] = true;
    last = worst.beyond;
  }
  return bad;
}

}  // namespace tank_datum
