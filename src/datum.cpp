#include "tank_datum/datum.h"

#include <algorithm>
#include <cmath>

#include "core/clauses.h"
#include "core/parallel.h"
#include "core/parts.h"
#include "core/plain_text.h"
#include "core/refusal.h"
#include "datum_stages.h"
#include "datum_status.h"
#include "foot_frame.h"
#include "foot_stages.h"
#include "limits/survey_spacing.h"
#include "locate/crop.h"
#include "locate/foot_unit.h"
#include "locate/locate.h"
#include "locate/narrow_ringwall.h"
#include "locate/ring_shape.h"
#include "refusals.h"
#include "setups/agreement.h"
#include "setups/merged_scans.h"
#include "setups/setup_shares.h"
#include "shape/analysis.h"
#include "shell/shell_measures.h"
#include "shell/shell_survey.h"
#include "sighting.h"
#include "stations/stations.h"
#include "tank_datum/core/error.h"
#include "trust/foot_density.h"
#include "trust/ground_inside.h"
#include "trust/tank_tests.h"
#include "trust/tests_of_tank.h"
#include "upper_foot.h"
#include "wall_above.h"

namespace tank_datum {
namespace {

/// The setups of a ring compared and adjusted to each other; the ring has its points for the search then: of labelled
/// setups as they were adjusted, else as they were given.
SetupAgreement adjustSetups(Ring& ring, const Scan& scan, const Tank& tank, const DatumOptions& options) {
  const bool labelled = ring.search.empty();
  const RepeatedPoints repeated = removeRepeated(ring);
  if (!labelled && repeated.removed > 0) thinForSearch(ring, tank, options.crop, options.threads);
  SetupAgreement agreement = agreeSetups(ring, repeated, scan, tank, options.setups, options.threads);
  if (labelled) thinForSearch(ring, tank, options.crop, options.threads);
  return agreement;
}

/// What the stations share through the setups that see them.
void shareErrors(Datum& datum, const Ring& ring) {
  const FootProfile& profile = datum.refined.profile;
  const FoundationBand band{profile.band_from, profile.band_to, profile.slope, profile.noise};
  const SetupShares shares = setupShares(ring, datum.tank, datum.stations, datum.circle.center, band);
  if (ring.setupCount() == 1) judgeMerged(datum.agreement, ring, datum.tank, datum.stations, datum.circle.center, band);
  SharedErrors shared = shareSetupErrors(datum.agreement, datum.stations, shares, profile.slope);
  datum.covariance = std::move(shared.covariance);
  datum.stations = withSharedErrors(std::move(datum.stations), shared);
  for (std::size_t i = 0; i < shared.seen.size(); ++i) {
    datum.agreement.setups[i].stations = shared.seen[i].size();
    datum.agreement.setups[i].seen = std::move(shared.seen[i]);
  }
  datum.refined.sigma_radius = std::hypot(datum.refined.sigma_radius, datum.agreement.radiusError());
}

/// The datum of what was measured at the foot, its stations described and tested.
Datum describeFoot(Datum datum, FootResult foot, const Ring& ring, const ShellEvidence& evidence,
                   const DatumOptions& options) {
  datum.edge_points = std::move(foot.edge_points);
  datum.curve = std::move(foot.curve);
  datum.circle = foot.circle;
  datum.refined = std::move(foot.refined);
  datum.stations = std::move(foot.stations);
  if (datum.refined.valid()) {
    for (const std::size_t i : stationsOffCircle(datum.stations, datum.circle, evidence)) {
      datum.stations[i].flag = StationFlag::Missing;
      datum.stations[i].reason = Unmeasured::OffCircle;
    }
    shareErrors(datum, ring);
  }
  datum = describeStations(std::move(datum), options);
  addClause(datum.message, foot.note);
  if (!datum.usable()) return datum;
  if (options.method == Method::Refined) {  // the paper's curve swings where nothing is seen
    const auto add = [&](const auto& more) { datum.tests.insert(datum.tests.end(), more.begin(), more.end()); };
    add(testsOfStations(datum.stations, datum.level, datum.tilt, evidence));
    add(testsOfSigma(datum.stations, footUnit(datum.tank.circle.radius, datum.tank.resolution)));
    add(testsOfGap(datum.refined.shell_from, ring.reach, evidence));
    add(testsUnderShell(datum.refined.under_shell));
    add(testsAboveShell(datum.refined.above_shell));
    add(testsOfRaised(datum.refined.raised));
  }
  return judgeTests(std::move(datum), options);
}

/// What the shape of the stations and of the shell means, beside the limits of the codes.
Datum withChecks(Datum datum, const DatumOptions& options) {
  const double sigma_radius = std::isfinite(datum.refined.sigma_radius) ? datum.refined.sigma_radius : 0.0;
  datum.analysis = analyse({datum.stations, datum.tilt, datum.circle.radius,
                            shellMeasures(datum.shell, options.analysis.facts, datum.circle.radius), datum.covariance,
                            kSurveySpacing, sigma_radius},
                           options.analysis);
  datum.stations = withParts(std::move(datum.stations), datum.analysis.out_of_plane.stations);
  datum.analysis.roundness = compareRoundness(datum.shell, options.analysis.limits, options.analysis.facts,
                                              {2.0 * datum.circle.radius, 2.0 * sigma_radius});
  datum.asked_height = options.analysis.facts.height;
  if (const std::string text = ringwallText(datum.tank); !text.empty()) datum.analysis.notes.push_back(text);
  for (const std::string& warning : warningsOf(datum)) datum.analysis.notes.push_back("Warning: " + warning);
  return datum;
}

/// The stages after the search for tanks.
/// @param upon  the tank on a narrow ringwall, if it may stand on one
Datum measureDatum(const Tank& tank, const Scan& scan, const DatumOptions& given, const Callbacks& callbacks,
                   std::optional<Tank>& upon) {
  if (!tank.circle.valid()) return withoutTank(scan, given);
  const ThreadScope threads(given.threads);
  const DatumOptions options = inUnits(given, footUnit(tank.circle.radius, tank.resolution));
  Datum datum = startDatum(scan);
  datum.tank = tank;
  if (!tank.has_foundation) return withoutFoundation(std::move(datum), scan, options);
  tell(callbacks, "crop");
  const std::uint64_t looked_at = scan.size() / rowStride(scan, tank, options.crop);
  ShellBands bands(tank, options.shell, looked_at);
  WallAbove wall(tank, options.crop.reach, looked_at);
  const auto also = [&](std::uint64_t n, const Points& block) {
    bands.gather(n, block);
    wall.gather(n, block);
  };
  Ring ring = cropRing(scan, tank, options.crop, also, options.threads);
  upon = onNarrowRingwall(ring, wall.points(), tank);
  datum.counts = ring.counts;
  tell(callbacks, "setups");
  datum.agreement = adjustSetups(ring, scan, tank, options);
  if (ring.search.size() < static_cast<std::size_t>(options.normals.k)) {
    return endDatum(datum, Status::TooFewPoints, "fewer points near the datum than neighbours asked for");
  }
  datum.foot_density = footDensity(ring, tank);
  const ShellEvidence evidence = lookAtShell(ring, tank);
  datum.lean = evidence.lean;
  datum.tests = concatenated<std::vector<TankTest>>(
      {testsOfShell(tank, evidence), testsOfGround(groundInside(ring, tank, evidence))});
  if (worstOf(datum.tests) == TestOutcome::Fail) return judgeTests(std::move(datum), options);
  FootResult foot = measureFoot(ring, onItsFoot(tank, evidence), evidence.lean, options, callbacks);
  tell(callbacks, "deformation");
  datum = describeFoot(std::move(datum), std::move(foot), ring, evidence, options);
  if (!datum.hasStations()) return datum;
  tell(callbacks, "shell");
  datum.shell = withSetupErrors(surveyShell(bands, datum.stations, datum.circle, options.shell, options.stations),
                                datum.agreement.errorsOfPoints(), datum.agreement.seeing());
  tell(callbacks, "checks");
  return withChecks(std::move(datum), options);
}

/// Of the tanks found the one that options.pick counts, or why there is none.
Datum extractPicked(const std::vector<Tank>& tanks, const Scan& scan, const DatumOptions& options,
                    const Callbacks& callbacks) {
  const auto picked = static_cast<std::size_t>(options.pick);
  if (tanks.empty() || picked <= tanks.size()) {
    return extractDatum(tanks.empty() ? Tank() : tanks[picked - 1], scan, options, callbacks);
  }
  Datum datum = startDatum(scan);
  datum.counts = countsOf(scan, options.threads);
  const std::string why =
      "only " + std::to_string(tanks.size()) + " found, no tank " + std::to_string(picked) + " to pick";
  return withSighting(endDatum(std::move(datum), Status::NoTank, why), scan, options);
}

}  // namespace

void requireValid(const DatumOptions& options) { refuseFirst(firstError(options)); }

const char* nameOf(Method method) { return method == Method::Refined ? "refined" : "paper"; }

std::vector<Tank> findTanks(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks) {
  requireValid(options);
  tell(callbacks, "locate");
  if (!options.tank) return locateTanks(scan, options.locate, options.threads);
  const Circle circle{options.tank->center - scan.origin().head<2>(), options.tank->radius};
  const std::optional<Tank> tank = describeTank(scan, circle, options.locate, options.threads);
  return tank ? std::vector<Tank>{*tank} : std::vector<Tank>{};
}

Datum extractDatum(const Tank& tank, const Scan& scan, const DatumOptions& options, const Callbacks& callbacks) {
  requireValid(options);
  std::optional<Tank> upon, none;
  Datum datum = measureDatum(tank, scan, options, callbacks, upon);
  if (upon && !(options.tank && isOfFace(options.tank->radius, *upon)))
    datum = upperOrLower(measureDatum(*upon, scan, options, callbacks, none), std::move(datum));
  if (!options.tank) {  // else the user has said which wall is the shell
    const double reach = reachOf(tank, options.crop.reach * footUnit(tank.circle.radius, tank.resolution));
    const WallStep step = stepInDoubt(datum, upon);
    datum = judgeMoreTests(std::move(datum), testsOfStep(step.width, step.height, reach), options);
  }
  return withSighting(std::move(datum), scan, options);
}

namespace {

/// Refuses to turn coordinates that were rounded: their steps are not seen any more then, and sigma_z would not hold
/// them.
void requireFine(const Datum& datum) {
  constexpr double kCoarsest = 0.0015;  // steps that do no harm [m]
  const double step = datum.refined.rounding;
  if (step < kCoarsest * footUnit(datum.tank.circle.radius, datum.tank.resolution)) return;
  throw Error(Error::Kind::Option, "level", "elevations", formatted("rounded to %g mm", 1e3 * step),
              "coordinates as they were measured, or no option level");
}

}  // namespace

Datum extractDatum(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks) {
  const std::vector<Tank> tanks = findTanks(scan, options, callbacks);
  if (callbacks.tanks) callbacks.tanks(tanks);
  Datum datum = extractPicked(tanks, scan, options, callbacks);
  if (!options.level || !datum.lean.known()) return datum;
  requireFine(datum);
  DatumOptions upright = options;
  upright.level = false;
  const Scan turned = turnedUpright(scan, datum);
  if (callbacks.turned) callbacks.turned(turned);
  const Callbacks again{callbacks.stage, {}, callbacks.normals};
  const std::vector<Tank> found = findTanks(turned, upright, again);
  const Eigen::Vector2d center = datum.tank.circle.center + (datum.origin - turned.origin()).head<2>();
  const auto same = std::min_element(found.begin(), found.end(), [&](const Tank& a, const Tank& b) {
    return (a.circle.center - center).squaredNorm() < (b.circle.center - center).squaredNorm();
  });
  return extractDatum(same == found.end() ? Tank() : *same, turned, upright, again);
}

std::vector<Datum> extractEveryDatum(const Scan& scan, const DatumOptions& options, const Callbacks& callbacks) {
  std::vector<Tank> tanks = findTanks(scan, options, callbacks);
  if (callbacks.tanks) callbacks.tanks(tanks);
  if (tanks.empty()) tanks.emplace_back();
  std::vector<Datum> datums;
  for (const Tank& tank : tanks) datums.push_back(extractDatum(tank, scan, options, callbacks));
  return datums;
}

}  // namespace tank_datum
