#include "tank_datum/datum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/refusal.h"
#include "datum_stages.h"
#include "foot_frame.h"
#include "locate/foot_unit.h"
#include "refusals.h"
#include "setups/agreement.h"
#include "setups/setup_report.h"
#include "setups/setup_shares.h"
#include "shell/shell_measures.h"
#include "shell/shell_survey_impl.h"
#include "tank_datum/core/error.h"
#include "tank_datum/core/parallel.h"
#include "trust/tests_of_tank.h"

namespace tank_datum {
namespace {

Datum begun(const Scan& scan) {
  Datum datum;
  datum.origin = scan.origin();
  datum.coordinate_step = scan.coordinateStep();
  return datum;
}

/// A word on coordinates too coarse for a datum of a fraction of a millimetre.
void warnOfSteps(Datum& datum) {
  constexpr double kCoarse = 0.001;  // [m]
  if (datum.coordinate_step < kCoarse) return;
  char text[96];
  std::snprintf(text, sizeof text, "its 4-byte coordinates have steps of %g mm here: store 8-byte ones",
                1000.0 * datum.coordinate_step);
  datum.message += (datum.message.empty() ? "" : "; ") + std::string(text);
}

Datum stopped(Datum datum, Status status, const std::string& message) {
  datum.status = status;
  datum.message = message;
  warnOfSteps(datum);
  datum.stations.clear();
  return datum;
}

/// Why there is no tank: no points to speak of, or none that stand like one.
Datum withoutTank(const Scan& scan, const DatumOptions& options) {
  Datum datum = begun(scan);
  datum.counts =
      scan.forEachChosen([](std::uint64_t, const Points&, Points&) {}, options.threads, [](const Points&) {});
  const std::uint64_t finite = datum.counts.points - datum.counts.invalid;
  if (finite < static_cast<std::uint64_t>(options.normals.k)) {
    return stopped(datum, Status::TooFewPoints, "fewer points in the scan than neighbours asked for");
  }
  return stopped(datum, Status::NoTank, whyNoTank(scan, options));
}

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

/// A missing station keeps its place on the fitted circle, and nothing else.
void blankMissing(Datum& datum) {
  for (Station& s : datum.stations) {
    if (s.flag != StationFlag::Missing) continue;
    Station blank;
    blank.azimuth = s.azimuth;
    blank.direction = s.direction;
    blank.x = datum.circle.center.x() + datum.circle.radius * std::cos(s.direction);
    blank.y = datum.circle.center.y() + datum.circle.radius * std::sin(s.direction);
    s = blank;
  }
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

/// Whether a circle has left the tank's by more than the ring in which the points were looked for.
bool isElsewhere(const Circle& circle, const Tank& tank, double reach) {
  return (circle.center - tank.circle.center).norm() + std::abs(circle.radius - tank.circle.radius) >
         reach + 2.0 * tank.resolution;
}

/// What the stations' elevations mean, and whether there are any.
Datum described(Datum datum, const DatumOptions& options) {
  const bool refined = options.method == Method::Refined;
  const std::string candidate = candidateText(datum.tank.circle, datum.tank.coverage, datum.origin) + ": ";
  if (!refined && !datum.curve.valid()) {
    return stopped(datum, Status::FitFailed, "too few edge points for a closed curve");
  }
  if (!refined && isElsewhere(datum.circle, datum.tank, options.crop.reach)) {
    return stopped(datum, Status::NoCrease, candidate + "the edge points do not lie along the foot of the shell");
  }
  if (refined && !datum.refined.valid()) {
    return stopped(datum, Status::NoCrease,
                   candidate + "no foundation surface meets the shell along enough of its foot");
  }
  datum.level = levelOf(datum.stations);
  if (datum.level.measured < 8) {
    return stopped(datum, Status::NoCrease,
                   candidate + "the shell meets one and the same surface at fewer than 8 stations");
  }
  blankMissing(datum);
  return meant(std::move(datum), options);
}

/// A datum whose shell, or whose stations, fail a test of whether this is a tank: refused, or doubtful.
Datum judged(Datum datum, const DatumOptions& options) {
  const TestOutcome worst = worstOf(datum.tests);
  if (worst == TestOutcome::Pass) return datum;
  const std::string findings = findingsOf(datum.tests);
  const std::string candidate = candidateText(datum.tank.circle, datum.tank.coverage, datum.origin);
  if (worst == TestOutcome::Fail) return stopped(datum, Status::NoTank, candidate + ", rejected: " + findings);
  const std::string before = datum.message.empty() ? "" : "; " + datum.message;
  datum.message =
      (options.accept ? "accepted, though " : candidate + ", doubtful (--accept takes it): ") + findings + before;
  if (!options.accept) datum.status = Status::Doubtful;
  return datum;
}

}  // namespace

void requireValid(const DatumOptions& options) { refuseFirst(firstError(options)); }

Datum meant(Datum datum, const DatumOptions& options) {
  datum.tilt = fitTilt(datum.stations, datum.circle.center, options.stations, datum.covariance);
  datum.antipodal = antipodalOf(datum.stations);
  datum.status = datum.level.missing == 0 ? Status::Ok : Status::Partial;
  if (datum.level.missing > 0) {
    datum.message = std::to_string(datum.level.missing) + " of " + std::to_string(datum.stations.size()) +
                    " stations are missing: the datum is not seen there";
  }
  const std::string units = doubtfulUnits(datum.circle.radius);
  if (!units.empty()) datum.message += (datum.message.empty() ? "" : "; ") + units;
  const std::string setups = setupMessage(datum.agreement, datum.stations);
  if (!setups.empty()) datum.message += (datum.message.empty() ? "" : "; ") + setups;
  warnOfSteps(datum);
  return datum;
}

std::string firstError(const DatumOptions& options) {
  for (const std::string& error :
       {firstError(options.locate), firstError(options.crop), firstError(options.normals), firstError(options.growing),
        firstError(options.centre_filter), firstError(options.spline), firstError(options.setups),
        firstError(options.refine), firstError(options.stations), firstError(options.analysis),
        firstError(options.shell)}) {
    if (!error.empty()) return error;
  }
  if (options.tank && !(options.tank->radius > 0.0 && std::isfinite(options.tank->radius))) {
    return "tank.radius = " + std::to_string(options.tank->radius) + " (must be > 0)";
  }
  if (options.tank && !options.tank->center.allFinite()) return "tank.center = not finite (must be X,Y in metres)";
  if (options.pick < 1) return "pick = " + std::to_string(options.pick) + " (must be >= 1)";
  if (options.threads < 0) return "threads = " + std::to_string(options.threads) + " (must be >= 0)";
  return {};
}

const char* nameOf(Status status) {
  switch (status) {
    case Status::NotRun:
      return "not_run";
    case Status::Ok:
      return "ok";
    case Status::Partial:
      return "partial";
    case Status::NoTank:
      return "no_tank";
    case Status::NoCrease:
      return "no_crease";
    case Status::TooFewPoints:
      return "too_few_points";
    case Status::FitFailed:
      return "fit_failed";
    case Status::Doubtful:
      return "doubtful";
  }
  return "";
}

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
    return stopped(Datum(), Status::NoTank,
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
  Datum datum = begun(scan);
  datum.tank = tank;
  const std::string candidate = candidateText(tank.circle, tank.coverage, datum.origin) + ": ";
  if (!tank.has_foundation) {
    return stopped(datum, Status::NoCrease,
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
    return stopped(datum, Status::TooFewPoints, "fewer points near the datum than neighbours asked for");
  }
  const ShellEvidence evidence = lookAtShell(ring, tank);
  datum.lean = evidence.lean;
  datum.tests = testsOfShell(tank, evidence);
  if (worstOf(datum.tests) == TestOutcome::Fail) return judged(std::move(datum), options);
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
  datum = described(std::move(datum), options);
  if (!datum.usable()) return datum;
  if (options.method == Method::Refined) {  // the paper's curve swings where nothing is seen
    const auto of_stations = testsOfStations(datum.stations, datum.level, datum.tilt, evidence);
    datum.tests.insert(datum.tests.end(), of_stations.begin(), of_stations.end());
  }
  datum = judged(std::move(datum), options);
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
