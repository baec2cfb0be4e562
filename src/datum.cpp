#include "tank_datum/datum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/refusal.h"
#include "datum_stages.h"
#include "datum_status.h"
#include "foot_frame.h"
#include "locate/foot_unit.h"
#include "refusals.h"
#include "setups/agreement.h"
#include "setups/setup_shares.h"
#include "shell/shell_measures.h"
#include "shell/shell_survey_impl.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/parallel.h"
#include "trust/tests_of_tank.h"

namespace tank_datum {
namespace {

void refine(Datum& datum, const Ring& ring, const DatumOptions& options) {
  datum.refined = refineStations(datum.stations, ring, datum.tank, options.refine, options.stations);
  datum.circle = datum.refined.circle;
}

/// What the stations share through the setups that see them.
void shareErrors(Datum& datum, const Ring& ring) {
  const FootProfile& profile = datum.refined.profile;
  const FoundationBand band{profile.band_from, profile.band_to, profile.slope, profile.noise};
  const SetupShares shares = setupShares(ring, datum.tank, datum.stations, datum.circle.center, band);
  datum.covariance = shareSetupErrors(datum.agreement, datum.stations, shares, profile.slope);
}

/// The stages at the foot, from the ring of the tank to its stations.
void measureFoot(Datum& datum, const Ring& ring, const DatumOptions& options,
                 const std::function<void(const char*)>& begin, const NormalStage& normal_stage) {
  begin("normals");
  const Normals normals = normal_stage ? normal_stage(ring.search, options.normals, options.threads)
                                       : estimateNormals(ring.search, options.normals, options.threads);
  begin("region_growing");
  const auto candidates = growCandidates(normals, options.growing, options.threads);
  begin("centre_filter");
  const EdgePoints edge = filterByCentre(ring.search, candidates, datum.tank.circle, options.centre_filter);
  for (const auto i : edge.indices) datum.edge_points.push_back(ring.search[static_cast<std::size_t>(i)]);
  begin("spline");
  datum.curve = fitClosedSpline(datum.edge_points, edge.azimuths, options.spline);
  datum.stations = emptyStations(options.stations);
  if (datum.curve.valid()) samplePaperCurve(datum.stations, datum.curve, edge, options.stations);
  datum.circle = edge.circle;
  begin("refine");
  if (options.method == Method::Refined) refine(datum, ring, options);
}

}  // namespace

void requireValid(const DatumOptions& options) { refuseFirst(firstError(options)); }

const char* nameOf(Method method) { return method == Method::Refined ? "refined" : "paper"; }

std::vector<Tank> findTanks(const Scan& scan, const DatumOptions& options, const StageObserver& observer) {
  requireValid(options);
  if (observer) observer("locate");
  if (!options.tank) return locateTanks(scan, options.locate, options.threads);
  const Circle circle{options.tank->center - scan.origin().head<2>(), options.tank->radius};
  const std::optional<Tank> tank = describeTank(scan, circle, options.locate, options.threads);
  return tank ? std::vector<Tank>{*tank} : std::vector<Tank>{};
}

Scan levelled(const Scan& scan, const Datum& datum) {
  const Eigen::Vector2d& center = datum.tank.circle.center;
  const Eigen::Vector3d foot(center.x(), center.y(), datum.tank.foot.coefficients[0]);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(datum.lean.axis(), Eigen::Vector3d::UnitZ());
  return scan.turnedAbout(foot + datum.origin, turn.toRotationMatrix());
}

Datum extractDatum(const Scan& scan, const DatumOptions& options, const StageObserver& observer,
                   const NormalStage& normal_stage) {
  Datum datum = extractDatumAmong(findTanks(scan, options, observer), scan, options, observer, normal_stage);
  if (!options.level || !datum.lean.known()) return datum;
  DatumOptions upright = options;
  upright.level = false;
  return extractDatum(levelled(scan, datum), upright, observer, normal_stage);
}

std::vector<Datum> extractDatums(const Scan& scan, const DatumOptions& options, const StageObserver& observer) {
  return extractDatumsOf(findTanks(scan, options, observer), scan, options, observer);
}

Datum extractDatumAmong(const std::vector<Tank>& tanks, const Scan& scan, const DatumOptions& options,
                        const StageObserver& observer, const NormalStage& normal_stage) {
  const auto picked = static_cast<std::size_t>(options.pick);
  if (tanks.empty()) return withoutTank(scan, options);
  if (picked > tanks.size()) {
    return endDatum(Datum(), Status::NoTank,
                    "only " + std::to_string(tanks.size()) + " found, no tank " + std::to_string(picked) + " to pick");
  }
  return extractDatumOf(tanks[picked - 1], scan, options, observer, normal_stage);
}

std::vector<Datum> extractDatumsOf(const std::vector<Tank>& tanks, const Scan& scan, const DatumOptions& options,
                                   const StageObserver& observer) {
  std::vector<Datum> datums;
  for (const Tank& tank : tanks) datums.push_back(extractDatumOf(tank, scan, options, observer));
  if (datums.empty()) datums.push_back(withoutTank(scan, options));
  return datums;
}

Datum extractDatumOf(const Tank& tank, const Scan& scan, const DatumOptions& given, const StageObserver& observer,
                     const NormalStage& normal_stage) {
  requireValid(given);
  const double unit = footUnit(tank.circle.radius, tank.resolution);
  const DatumOptions options = inUnits(given, unit);
  const ThreadScope threads(options.threads);
  const auto begin = [&](const char* stage) {
    if (observer) observer(stage);
  };
  Datum datum = startDatum(scan);
  datum.tank = tank;
  const std::string candidate = candidateText(tank.circle, tank.coverage, datum.origin) + ": ";
  if (!tank.has_foundation) {
    return endDatum(datum, Status::NoCrease,
                    candidate + "no surface meets the foot of the shell" + otherAxis(scan, options));
  }
  begin("crop");
  ShellBands bands(tank, options.shell, scan.size() / rowStride(scan, tank, options.crop));
  const AlsoGathered shell{
      [&bands](std::uint64_t n, const Points& block, std::vector<char>& wanted) { bands.mark(n, block, wanted); },
      [&bands](const Points& block) { bands.add(block); }};
  Ring ring = cropRing(scan, tank, options.crop, shell, options.threads);
  datum.counts = ring.counts;
  begin("setups");
  datum.agreement = agreeSetups(ring, scan, tank, options.setups, options.threads);
  if (ring.search.empty() || datum.agreement.repeated_points > 0) {
    thinForSearch(ring, tank, options.crop, options.threads);
  }
  if (ring.search.size() < static_cast<std::size_t>(options.normals.k)) {
    return endDatum(datum, Status::TooFewPoints, "fewer points near the datum than neighbours asked for");
  }
  const ShellEvidence evidence = lookAtShell(ring, tank);
  datum.lean = evidence.lean;
  datum.tests = testsOfShell(tank, evidence);
  if (worstOf(datum.tests) == TestOutcome::Fail) return judgeTests(std::move(datum), options);
  const FootFrame frame(tank, evidence.lean);
  if (frame.isScans()) {
    measureFoot(datum, ring, options, begin, normal_stage);
  } else {
    datum.tank = frame.into(tank);
    measureFoot(datum, frame.into(ring), options, begin, normal_stage);
    datum.tank = tank;
    frame.backFrom(datum);
  }
  begin("deformation");
  if (datum.refined.valid()) {
    dropOffCircle(datum.stations, datum.circle, evidence);
    shareErrors(datum, ring);
  }
  datum = describeStations(std::move(datum), options);
  if (!datum.usable()) return datum;
  if (options.method == Method::Refined) {  // the paper's curve swings where nothing is seen
    const auto of_stations = testsOfStations(datum.stations, datum.level, datum.tilt, evidence);
    datum.tests.insert(datum.tests.end(), of_stations.begin(), of_stations.end());
  }
  datum = judgeTests(std::move(datum), options);
  if (!datum.hasStations()) return datum;
  begin("shell");
  datum.shell = surveyShell(bands, datum.stations, datum.circle, options.shell, options.stations);
  begin("checks");
  datum.analysis = analyse(datum.stations, datum.tilt, datum.circle.radius, options.analysis,
                           shellMeasures(datum.shell, options.analysis.facts), datum.covariance);
  datum.asked_height = options.analysis.facts.height;
  for (const std::string& warning : warningsOf(datum)) datum.analysis.notes.push_back("Warning: " + warning);
  return datum;
}

}  // namespace tank_datum
