#include "foot/foot_passes.h"

#include <utility>

#include "core/parallel.h"
#include "core/statistics.h"
#include "fit/circular_series.h"
#include "foot/hidden_strip.h"
#include "foot/liquid_level.h"
#include "foot/mixed_levels.h"
#include "foot/rough_arcs.h"
#include "foot/under_shell.h"
#include "tank_datum/core/unknown.h"

namespace tank_datum {
namespace {

/// Section, slopes and a fit of every station, from the elevations known so far.
/// @param before  the pass before, whose sections are kept where these show another surface
FootPass runPass(const Foot& foot, const FootElevations& elevations, const FootPass& before) {
  FootPass pass;
  pass.stood = stoodBefore(elevations, before.outliers);
  const std::vector<double> fitted = before.priors.settled ? elevationsOf(before.fits) : std::vector<double>{};
  pass.sections = stackKnown(foot, elevations.known, fitted);
  if (isResolved(foot)) pass.sections = heldTo(before.sections, std::move(pass.sections), foot.reach);
  pass.priors = learnPriors(foot, elevations, pass.sections);
  pass.fits.resize(foot.directions.size());
  forEachIndex(pass.fits.size(), 0, [&](std::size_t i) {
    if (elevations.seen[i]) {
      pass.fits[i] = fitStation(foot, i, elevations.filled[i], pass.sections.at(i), pass.priors);
    }
  });
  return pass;
}

/// What a pass leaves to the next one, which looks beside what was found too: a section over several degrees shows no
/// surface in the middle of a dip.
FootElevations elevationsAfter(const Foot& foot, const FootPass& pass, FootElevations before) {
  const std::vector<double> elevations = elevationsOf(pass.fits);
  std::vector<double> known = withoutOutliers(elevations, pass.outliers, pass.priors.settled);
  const std::vector<bool> beside = closeTo(foot, known);
  for (std::size_t i = 0; i < beside.size(); ++i) before.seen[i] = before.seen[i] || beside[i];
  return {std::move(known), filledUp(elevations), std::move(before.seen), before.below_most};
}

/// The elevations of stations whose shell is not seen are not stacked.
FootElevations whereShellIsSeen(FootElevations elevations, const Foot& foot) {
  for (std::size_t i = 0; i < foot.shell_seen.size(); ++i) {
    if (!foot.shell_seen[i]) elevations.known[i] = kUnknown;
  }
  return elevations;
}

/// Leaves out stations under whose wall the foundation is seen to go on, where these are few: that wall is no shell.
FootPass withoutCladding(const Foot& foot, FootPass pass, const std::vector<double>& levels) {
  const UnderShell under = findUnderShell(foot, pass.fits, levels);
  if (!under.isOfFew()) {
    pass.under_shell = under.share;
    return pass;
  }
  pass.under_shell = 0.0;
  for (std::size_t i = 0; i < pass.fits.size(); ++i) {
    if (under.seen[i]) pass.outliers.reasons[i] = Unmeasured::OffCircle;
  }
  pass.fits = standing(std::move(pass.fits), pass.outliers.reasons);
  return pass;
}

/// A pass over what stands beside liquid that was left out of the one before it: upon it the floor had another slope
/// and section. What was said of the stations that do not stand, and of the whole ring, stays.
/// @param elevations  with those of the liquid
FootPass besideLiquid(const Foot& foot, const FootElevations& elevations, const FootPass& before) {
  FootPass pass = runPass(foot, elevationsAfter(foot, before, elevations), before);
  pass.outliers = findOutliers(foot, pass);
  for (std::size_t i = 0; i < pass.fits.size(); ++i) {
    if (before.outliers.reasons[i] == Unmeasured::None) continue;
    pass.outliers.reasons[i] = before.outliers.reasons[i];
    pass.outliers.refused[i] = before.outliers.refused[i];
  }
  pass.fits = standing(std::move(pass.fits), pass.outliers.reasons);
  pass.sections.whole.unseen = before.sections.whole.unseen;
  pass.under_shell = before.under_shell, pass.liquid = before.liquid;
  return pass;
}

/// A first pass upon what passes for a lip, which two levels make that are stacked together: upon one of them, if its
/// surface goes on beyond that lip; else as it was.
/// @param elevations  that it begins with
FootPass uponOneLevel(const Foot& foot, FootPass first, FootElevations& elevations) {
  const FootProfile& lip = first.sections.whole;
  if (lip.surface != Surface::AnnularPlate) return first;
  const OneLevel one = ofOneLevel(elevations.known, lip, foot.arc(), foot.reach);
  if (one.known.empty()) return first;
  FootElevations level{one.known, filledUp(one.known), closeTo(foot, one.known), one.below_most};
  FootPass second = runPass(foot, level, {});
  if (!goesOnFarther(second.sections.whole, lip)) return first;
  elevations = std::move(level);
  return second;
}

/// The first pass, upon a surface that a tank may stand on. Where a bank lies against most of a shell it is the surface
/// that most stations show; what the others show is looked for then, once, and must be no bank's end.
/// @param elevations  that it begins with
FootPass runFirstPass(const Foot& foot, const Tank& tank, FootElevations& elevations) {
  constexpr double kGentle = 0.1;  // a foundation's slope; a bank is as gentle where it ends [m/m]
  const auto look = [&](const std::vector<bool>& left_out) {
    return alignedElevations(foot, whereShellIsSeen(firstElevations(foot, tank, left_out), foot));
  };
  elevations = look({});
  FootPass first = uponOneLevel(foot, runPass(foot, elevations, {}), elevations);
  if (!first.priors.falls()) return first;
  std::vector<bool> bank;
  for (const FootFit& fit : first.fits) bank.push_back(fit.valid());
  FootElevations others = look(bank);
  if (finiteOf(others.known).empty()) return first;
  FootPass second = runPass(foot, others, {});
  if (second.priors.seen < -kGentle) return first;
  elevations = std::move(others);
  return second;
}

}  // namespace

FootPass runPasses(const Foot& foot, const Tank& tank, FootElevations& elevations) {
  constexpr int kPasses = 3;  // the section sharpens as the elevations do; the third moves a few stations by 0.1 mm
  FootPass pass = runFirstPass(foot, tank, elevations);
  for (int i = 0; i < kPasses; ++i) {
    if (i > 0) pass = runPass(foot, elevations, pass);
    if (pass.sections.whole.unseen > 0.0) return pass;
    pass.outliers = findOutliers(foot, pass);
    elevations = elevationsAfter(foot, pass, std::move(elevations));
  }
  if (isResolved(foot)) pass.sections.whole.unseen = hiddenBesideShell(foot, pass, elevations.filled);
  pass.fits = standing(std::move(pass.fits), pass.outliers.reasons);
  if (!isResolved(foot)) return pass;
  pass = withoutRoughArcs(foot, withoutCladding(foot, std::move(pass), elevations.filled));
  pass = withoutLiquid(foot, std::move(pass));
  return pass.hasLiquid() ? besideLiquid(foot, elevations, pass) : pass;
}

}  // namespace tank_datum
