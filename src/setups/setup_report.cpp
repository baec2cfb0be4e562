#include "setups/setup_report.h"

#include <algorithm>
#include <cmath>

#include "core/clauses.h"
#include "core/plain_text.h"
#include "core/statistics.h"
#include "core/units.h"
#include "locate/crop.h"

namespace tank_datum {
namespace {

std::string millimetres(double metres) {
  char text[32];
  snprintfPlain(text, sizeof text, "%.1f mm", 1e3 * metres);
  return text;
}

/// How many stations are seen by bad setups alone.
std::size_t seenByBadAlone(const SetupAgreement& agreement, const std::vector<Station>& stations) {
  std::vector<char> good(stations.size(), 0), bad(stations.size(), 0);
  for (const Setup& setup : agreement.setups) {
    for (const std::size_t i : setup.seen) (setup.verdict == SetupVerdict::Bad ? bad : good)[i] = 1;
  }
  std::size_t alone = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) alone += bad[i] && !good[i];
  return alone;
}

/// Which setups are said to have stood where they cannot have; empty where none is.
std::string refusedOrigins(const SetupAgreement& agreement) {
  std::size_t refused = 0;
  const Setup* farthest = nullptr;
  for (const Setup& setup : agreement.setups) {
    if (setup.origin_refused == 0.0) continue;
    ++refused;
    if (!farthest || setup.origin_refused > farthest->origin_refused) farthest = &setup;
  }
  if (!farthest) return "";
  const std::string other = refused > 1 ? " and " + std::to_string(refused - 1) + " more" : "";
  return "setup " + farthest->name + other + " cannot have stood where the file says, " +
         fixedText(farthest->origin_refused, 0) + " m from the tank: taken as unknown";
}

/// The setups of the higher group, of two, against the lower one's.
std::string groupsOf(const SetupAgreement& agreement) {
  return formatted(
      "setup %s and %zu more are higher than the others by %.1f mm, and agree among themselves as these do: two "
      "surveys "
      "in one scan?",
      agreement.setups[agreement.higher.front()].name.c_str(), agreement.higher.size() - 1,
      1e3 * agreement.groups_apart);
}

/// How badly setups are registered, where that is far worse than usual; empty elsewhere, and where it was given.
std::string poorRegistration(const SetupAgreement& agreement) {
  constexpr double kPoor = 0.010;  // five times what is usual [m]
  std::string text;
  if (agreement.given.height == 0.0 && agreement.spread.height > kPoor)
    addClause(text, formatted("setups are registered to about %.1f mm in height only", 1e3 * agreement.spread.height));
  if (agreement.given.plan == 0.0 && agreement.spread.plan > kPoor)
    addClause(text, formatted("setups are registered to about %.1f mm in plan only", 1e3 * agreement.spread.plan));
  return text;
}

/// What is wrong with a bad setup, the larger of the two.
std::string faultOf(const Setup& setup) {
  constexpr double kFar = 30.0;  // [m], at which a tilt is compared with a shift
  const double tilt = std::hypot(setup.correction.tilt_x, setup.correction.tilt_y);
  const double plan = std::hypot(setup.correction.dx, setup.correction.dy);
  char text[64];
  if (kFar * tilt > std::max(std::abs(setup.correction.dz), plan)) {
    snprintfPlain(text, sizeof text, "tilted by %.0f arc-seconds", toArcSeconds(tilt));
  } else if (std::abs(setup.correction.dz) >= plan) {
    snprintfPlain(text, sizeof text, "%.1f mm too %s", 1e3 * std::abs(setup.correction.dz),
                  setup.correction.dz < 0.0 ? "high" : "low");
  } else {
    snprintfPlain(text, sizeof text, "%.1f mm off in plan", 1e3 * plan);
  }
  return text;
}

double sharedError(const std::vector<Station>& stations) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (std::isfinite(s.sigma_setup)) sigmas.push_back(s.sigma_setup);
  }
  return median(std::move(sigmas));
}

double ownError(const std::vector<Station>& stations) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (std::isfinite(s.sigma_setup))
      sigmas.push_back(std::sqrt(std::max(0.0, s.sigma_z * s.sigma_z - s.sigma_setup * s.sigma_setup)));
  }
  return median(std::move(sigmas));
}

}  // namespace

std::string setupMessage(const SetupAgreement& agreement, const std::vector<Station>& stations) {
  constexpr double kPlain = 2.0;  // times the stations' own error: a disagreement worth a word
  std::string text;
  for (const Setup& setup : agreement.setups) {
    if (setup.verdict == SetupVerdict::Bad)
      addClause(text, "setup " + setup.name + " does not agree with the others: " + faultOf(setup));
    if (setup.verdict == SetupVerdict::Duplicate)
      addClause(text, "setup " + setup.name + " holds the points of another one: used once");
  }
  if (agreement.groups_apart > kPlain * ownError(stations)) addClause(text, groupsOf(agreement));
  if (agreement.adjusted()) addClause(text, poorRegistration(agreement));
  if (agreement.too_many)
    addClause(text, "more than " + std::to_string(kMostSetups) + " files or labels are not told apart");
  if (agreement.split == SplitSetups::ByLabel)
    addClause(text, "files are parts of one cloud: points of equal labels are taken to be of one setup");
  if (agreement.split == SplitSetups::ByDensity)
    addClause(text, "files or labels that show the same of the shell are taken to be parts of one setup");
  if (agreement.no_setups) addClause(text, "files or labels are no setups, as tiles are none, and were taken together");
  if (agreement.adjusted()) addClause(text, refusedOrigins(agreement));
  const std::size_t alone = seenByBadAlone(agreement, stations);
  if (alone > 0) addClause(text, std::to_string(alone) + " stations are seen by bad setups alone");
  const bool named = std::any_of(agreement.setups.begin(), agreement.setups.end(),
                                 [](const Setup& s) { return s.verdict == SetupVerdict::Duplicate; });
  if (agreement.repeated_points > 0 && !named)
    addClause(text,
              std::to_string(agreement.repeated_points) + " points near the foot are there more than once: used once");
  const std::string advice = agreement.too_many ? "" : ": give them as separate files";
  if (agreement.unlabelled_discrepancy > kPlain * ownError(stations)) {
    addClause(text, "scans of several setups disagree by about " + millimetres(agreement.unlabelled_discrepancy) +
                        " here" + advice);
  } else if (agreement.merged_sigma > 0.0 && agreement.unlabelled_discrepancy == 0.0) {
    addClause(text, "scans of several setups are not told apart, their heights " +
                        std::string(agreement.given.height > 0.0 ? "given" : "taken") + " to be known to " +
                        millimetres(agreement.merged_sigma) + advice);
  }
  return text;
}

std::string setupSummary(const SetupAgreement& agreement, const std::vector<Station>& stations,
                         const std::function<std::string(double)>& length) {
  const auto has_points = [](const Setup& setup) { return setup.points > 0; };
  const auto seen = std::count_if(agreement.setups.begin(), agreement.setups.end(), has_points);
  if (agreement.merged_sigma > 0.0) {
    const bool seen_to_disagree = agreement.unlabelled_discrepancy > 0.0;
    return "several, not told apart; shared error " + length(sharedError(stations)) +
           (seen_to_disagree               ? ""
            : agreement.given.height > 0.0 ? ", as given"
                                           : ", assumed");
  }
  std::string text = std::to_string(agreement.adjusted() ? static_cast<std::ptrdiff_t>(agreement.setups.size())
                                                         : std::max<std::ptrdiff_t>(1, seen));
  if (!agreement.adjusted()) return text;
  if (agreement.by_order) text += " by the order of the points";
  if (std::isfinite(agreement.rms_before)) {
    text += ", disagreeing by " + length(agreement.rms_before) + ", adjusted";
  } else {
    text += ", none sees what another sees";
  }
  for (const Setup& setup : agreement.setups) {
    if (setup.verdict == SetupVerdict::Bad) text += ", " + setup.name + " bad";
  }
  return text + "; shared error " + length(sharedError(stations));
}

}  // namespace tank_datum
