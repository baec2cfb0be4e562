#include "setups/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/parallel.h"
#include "core/plain_text.h"
#include "locate/foot_unit.h"
#include "setups/gross_shifts.h"
#include "setups/one_tripod.h"
#include "setups/parts_by_order.h"
#include "setups/rounded_points.h"
#include "setups/setup_adjustment.h"
#include "setups/setup_ring.h"
#include "setups/setup_verdicts.h"
#include "setups/setup_views.h"
#include "setups/shell_arcs.h"
#include "setups/split_setups.h"
#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

constexpr const char* kAll = "all";  ///< name of setups taken together

/// The setups of a ring with the number of their points, whose middle is the origin.
std::vector<Setup> countSetups(const Ring& ring) {
  std::vector<Setup> setups(ring.setupCount());
  for (std::size_t i = 0; i < ring.points.size(); ++i) {
    Setup& setup = setups[ring.setupOf(i)];
    setup.origin += ring.points[i];
    ++setup.points;
  }
  for (Setup& setup : setups) setup.origin /= static_cast<double>(std::max<std::size_t>(1, setup.points));
  return setups;
}

/// The setups of a ring, their names, and where they stood as the options say, or the files.
/// @throws Error{Option} when a place given by the options is too far from the setup's points to be true
std::vector<Setup> setupsOf(const Ring& ring, const Scan& scan, double radius, const SetupOptions& options,
                            SplitSetups split) {
  constexpr double kFarthest = 100.0;  // radii: a beam of 0.3 milliradians is 3 % of the radius wide there
  std::vector<Setup> setups = countSetups(ring);
  if (setups.size() < ring.setups.size()) {
    setups.front().name = kAll;
    return setups;
  }
  for (std::size_t s = 0; s < ring.setups.size(); ++s) {
    Setup& setup = setups[s];
    if (split == SplitSetups::ByLabel) setup.name = scan.setupLabel(ring.setups[s]);
    if (setup.name.empty()) setup.name = scan.setupName(ring.setups[s]);
    const auto given = options.origins.find(setup.name);
    const bool is_given = given != options.origins.end();
    auto place = scan.setupOrigin(ring.setups[s]);
    if (is_given) place = given->second - scan.origin();
    if (!place) continue;
    const double distance = setup.points > 0 ? (*place - setup.origin).norm() : 0.0;
    setup.origin_known = distance <= kFarthest * radius;
    if (setup.origin_known) {
      setup.origin = *place;
    } else if (is_given) {
      throw Error(Error::Kind::Option, "setups", "origin of " + setup.name,
                  fixedText(distance, 0) + " m from its points",
                  fixedText(kFarthest, 0) + " radii of the tank or less, in the frame and units of the scan");
    } else {
      setup.origin_refused = distance;
    }
  }
  return setups;
}

/// Moves every point by its setup's correction.
void move(Ring& ring, const std::vector<Setup>& setups, int threads) {
  forEachRun(ring.points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Setup& setup = setups[ring.setupOf(i)];
      ring.points[i] = setup.correction(ring.points[i], setup.origin);
    }
  });
}

/// Refuses places of setups that no file has: a name mistyped must not pass for a place not known.
void requireKnown(const Scan& scan, const std::vector<Setup>& setups, const SetupOptions& options) {
  for (const auto& [name, place] : options.origins) {
    const auto is_named = [&name = name](const Setup& setup) { return setup.name == name; };
    const auto is_stem = [&name = name](const std::string& path) {
      return std::filesystem::path(path).stem() == name;  // of a file without a point near the datum
    };
    if (std::any_of(setups.begin(), setups.end(), is_named)) continue;
    if (std::any_of(scan.paths().begin(), scan.paths().end(), is_stem)) continue;
    throw Error(Error::Kind::Option, "setups", "origin of", name, "the stem of a scan, or a label");
  }
}

std::vector<Setup> countParts(const Ring& ring) {
  std::vector<Setup> parts = countSetups(ring);
  for (std::size_t part = 0; part < parts.size(); ++part) parts[part].name = "part " + std::to_string(part + 1);
  return parts;
}

/// Tells the setups of a cloud merged without labels apart by the order of its points. False where that says nothing.
bool partByOrder(Ring& ring, const Tank& tank, SetupAgreement& agreement, int threads) {
  const std::vector<std::size_t> begins = partsByOrder(ring, tank, threads);
  if (begins.size() < 2) return false;
  ring.setups.assign(begins.size(), SetupKey{});
  ring.point_setups.assign(ring.points.size(), 0);
  const auto at = [&](std::size_t part) {
    return ring.point_setups.begin() + static_cast<std::ptrdiff_t>(begins[part]);
  };
  for (std::size_t part = 1; part < begins.size(); ++part) {
    std::fill(at(part), part + 1 < begins.size() ? at(part + 1) : ring.point_setups.end(),
              static_cast<std::uint16_t>(part));
  }
  agreement.setups = countParts(ring);
  return true;
}

/// Makes one setup of the parts that one tripod scanned. False where each was a setup of its own.
bool uniteParts(Ring& ring, const SetupAdjustment& adjusted, std::vector<Setup>& parts) {
  const std::vector<std::uint16_t> setups = setupsOfParts(adjusted);
  const std::size_t count = std::size_t{1} + *std::max_element(setups.begin(), setups.end());
  if (count == parts.size() || count == 1) return false;
  for (std::uint16_t& setup : ring.point_setups) setup = setups[setup];
  ring.setups.resize(count);
  parts = countParts(ring);
  return true;
}

/// Whether it is known of all setups that they stood at places of their own.
bool standApart(const std::vector<Setup>& setups) {
  for (std::size_t i = 0; i < setups.size(); ++i) {
    if (!setups[i].origin_known) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if ((setups[i].origin - setups[k].origin).norm() <= kTripodsApart) return false;
    }
  }
  return true;
}

/// Makes one setup of all.
void takeTogether(Ring& ring, std::vector<Setup>& setups) {
  ring.setups.resize(1);
  ring.point_setups.clear();
  setups = countSetups(ring);
  setups.front().name = kAll;
}

void fill(SetupAgreement& agreement, const SetupAdjustment& adjusted) {
  for (std::size_t s = 0; s < agreement.setups.size(); ++s) {
    Setup& setup = agreement.setups[s];
    const auto at = static_cast<Eigen::Index>(s) * SetupMotion::kParameters;
    setup.correction = SetupMotion::of(-adjusted.errors.segment<SetupMotion::kParameters>(at));
    setup.sigma = SetupMotion::of(adjusted.covariance.diagonal().segment<SetupMotion::kParameters>(at).cwiseSqrt());
    setup.rms_before = adjusted.rms_before[s];
    setup.rms_after = adjusted.rms_after[s];
    setup.verdict = verdictOf(setup, adjusted.bad[s], std::isfinite(setup.rms_before));
    if (adjusted.groups.higher[s]) agreement.higher.push_back(s);
  }
  agreement.groups_apart = adjusted.groups.apart;
  agreement.spread = adjusted.spread;
  agreement.height_estimated = adjusted.height_estimated;
  agreement.tilt_estimated = adjusted.tilt_estimated;
  agreement.plan_estimated = adjusted.plan_estimated;
  agreement.rms_before = adjusted.all_before;
  agreement.rms_after = adjusted.all_after;
  agreement.covariance = adjusted.covariance;
}

}  // namespace

SetupAgreement agreeSetups(Ring& ring, const RepeatedPoints& repeated, const Scan& scan, const Tank& tank,
                           const SetupOptions& options, int threads) {
  SetupAgreement agreement;
  if (ring.points.empty()) return agreement;
  spreadRounded(ring, footUnit(tank.circle.radius, tank.resolution));
  agreement.repeated_points = repeated.removed;
  agreement.given = {options.error, options.tilt, options.error};
  std::optional<SetupRing> polar;
  if (!ring.point_setups.empty()) polar.emplace(ring, tank, threads);
  std::vector<ShellArcs> shown;
  const auto look = [&] { shown = shellArcsOfSetups(*polar, tank, ring.reach, ring.setups.size()); };
  std::vector<Eigen::Vector3d> origins(ring.setups.size(), Eigen::Vector3d::Zero());
  const auto views_in = [&](const ViewScope& scope) {
    return viewArcs(*polar, tank, ring.reach, origins, scope, threads);
  };
  const auto views_from_nowhere = [&] { return views_in({}); };
  if (polar) look(), agreement.split = joinSplitSetups(ring, shown, scan, views_from_nowhere);
  const bool joined = agreement.split != SplitSetups::None;
  if (joined) polar.emplace(ring, tank, threads), look();
  agreement.setups = setupsOf(ring, scan, tank.circle.radius, options, agreement.split);
  agreement.too_many = agreement.setups.size() < ring.setups.size();
  requireKnown(scan, agreement.setups, options);
  const auto has_points = [](const Setup& setup) { return setup.points > 0; };
  if (std::count_if(agreement.setups.begin(), agreement.setups.end(), has_points) < 2) {
    if (!joined) markDuplicates(agreement.setups, repeated);
    ring.point_setups.clear();
    agreement.by_order = !joined && partByOrder(ring, tank, agreement, threads);  // parts would come again and again
    if (!agreement.by_order) return agreement;
    polar.emplace(ring, tank, threads);
  }
  const bool apart = standApart(agreement.setups);
  if (!agreement.by_order && areNoSetups(shown, tank, apart)) {
    agreement.no_setups = true;
    takeTogether(ring, agreement.setups);  // each may hold pieces of several: their order says nothing
    return agreement;
  }
  const auto adjust = [&] {
    const std::size_t setups = agreement.setups.size();
    origins.clear();
    for (const Setup& setup : agreement.setups) origins.push_back(setup.origin);
    return adjustSetups(viewWithGrossShifts(views_in, setups, ring.reach, options), setups, options);
  };
  SetupAdjustment adjusted = adjust();
  if (agreement.by_order && uniteParts(ring, adjusted, agreement.setups)) {
    polar.emplace(ring, tank, threads);
    adjusted = adjust();
  }
  fill(agreement, adjusted);
  if (!agreement.by_order && !joined) markDuplicates(agreement.setups, repeated);
  move(ring, agreement.setups, threads);
  if (options.bad == BadSetups::Drop) dropBad(ring, agreement.setups, tank.circle.center);
  return agreement;
}

}  // namespace tank_datum
