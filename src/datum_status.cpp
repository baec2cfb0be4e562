#include "datum_status.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/clauses.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "refusals.h"
#include "setups/setup_report.h"
#include "shape/deformation.h"
#include "stations/stations.h"
#include "trust/foot_density.h"
#include "trust/tank_tests.h"

namespace tank_datum {
namespace {

/// A word on coordinates too coarse for a datum of a fraction of a millimetre.
void warnOfSteps(Datum& datum) {
  constexpr double kCoarse = 0.001;  // [m]
  if (datum.coordinate_step <= kCoarse) return;
  char text[96];
  snprintfPlain(text, sizeof text, "its coordinates have steps of %g mm here: store 8-byte ones, or a finer scale",
                1000.0 * datum.coordinate_step);
  addClause(datum.message, text);
}

/// A datum that does not exist for want of a foot.
Datum withoutCrease(Datum datum, std::string message, int stations) {
  addClause(message, sparseFoot(datum.foot_density));
  addClause(message, fineStations(datum.foot_density, stations));
  return endDatum(std::move(datum), Status::NoCrease, message);
}

std::string whyNoSurface(const FootProfile& profile) {
  if (!(profile.unseen > 0.0)) return "no foundation surface meets the shell along enough of its foot";
  char text[120];
  snprintfPlain(text, sizeof text,
                "the foundation is first seen %.0f mm from the shell: a lip or a gutter may be hidden",
                1e3 * profile.unseen);
  return text;
}

/// What the stations say of a foot at which next to none stands.
std::string whyNoStations(const std::vector<Station>& stations, double falls) {
  const auto count = [&](Unmeasured reason) {
    return std::count_if(stations.begin(), stations.end(), [&](const Station& s) { return s.reason == reason; });
  };
  const std::ptrdiff_t hidden = count(Unmeasured::Hidden), others = count(Unmeasured::OtherSurface);
  std::string why = "the shell meets one and the same surface at fewer than 8 stations";
  if (hidden > 0) addClause(why, formatted("%td of %zu stations show too few points of it", hidden, stations.size()));
  if (others > 0) addClause(why, formatted("%td stations show another surface", others));
  if (falls > 0.0)
    addClause(why, formatted("what meets it falls by %.2g m/m, as soil, an apron or a fillet does", falls));
  return why;
}

/// A missing station keeps its place on the fitted circle, and what was refused in its gap.
void blankMissing(Datum& datum) {
  for (Station& s : datum.stations) {
    if (s.flag != StationFlag::Missing) continue;
    Station blank;
    blank.azimuth = s.azimuth;
    blank.direction = s.direction;
    blank.reason = s.reason;
    blank.z_refused = s.z_refused;
    blank.x = datum.circle.center.x() + datum.circle.radius * portable::cos(s.direction);
    blank.y = datum.circle.center.y() + datum.circle.radius * portable::sin(s.direction);
    s = blank;
  }
}

/// Whether a circle has left the tank's by more than the ring in which the points were looked for.
bool isElsewhere(const Circle& circle, const Tank& tank, double reach) {
  return (circle.center - tank.circle.center).norm() + std::abs(circle.radius - tank.circle.radius) >
         reach + 2.0 * tank.resolution;
}

}  // namespace

Datum startDatum(const Scan& scan) {
  Datum datum;
  datum.origin = scan.origin();
  datum.coordinate_step = scan.coordinateStep();
  return datum;
}

Datum endDatum(Datum datum, Status status, const std::string& message) {
  datum.status = status;
  datum.message = message;
  warnOfSteps(datum);
  datum.stations.clear();
  return datum;
}

ScanCounts countsOf(const Scan& scan, int threads) {
  return scan.forEachChosen([](std::uint64_t, const Points&, Points&) {}, threads, [](const Points&) {});
}

Datum withoutTank(const Scan& scan, const DatumOptions& options) {
  Datum datum = startDatum(scan);
  datum.counts = countsOf(scan, options.threads);
  const std::uint64_t finite = datum.counts.kept();
  if (finite < static_cast<std::uint64_t>(options.normals.k)) {
    return endDatum(datum, Status::TooFewPoints, "fewer points in the scan than neighbours asked for");
  }
  const std::string why = whyNoTank(scan, options, datum.sighting.circle);
  return endDatum(datum, Status::NoTank, why);
}

Datum withoutFoundation(Datum datum, const Scan& scan, const DatumOptions& options) {
  const std::string candidate = candidateText(datum.tank.circle, datum.tank.coverage, datum.origin);
  return endDatum(std::move(datum), Status::NoCrease,
                  candidate + ": no surface meets the foot of the shell" + otherAxis(scan, options));
}

Datum describeStations(Datum datum, const DatumOptions& options) {
  const bool refined = options.method == Method::Refined;
  const std::string candidate = candidateText(datum.tank.circle, datum.tank.coverage, datum.origin) + ": ";
  if (!refined && !datum.curve.valid()) {
    return endDatum(datum, Status::FitFailed, "too few edge points for a closed curve");
  }
  if (!refined && isElsewhere(datum.circle, datum.tank, options.crop.reach)) {
    return withoutCrease(std::move(datum), candidate + "the edge points do not lie along the foot of the shell",
                         options.stations.count);
  }
  if (refined && !datum.refined.valid()) {
    const std::string why = whyNoSurface(datum.refined.profile);
    return withoutCrease(std::move(datum), candidate + why, options.stations.count);
  }
  datum.level = levelOf(datum.stations);
  if (datum.level.measured < 8) {
    const std::string why = whyNoStations(datum.stations, datum.refined.falls);
    return withoutCrease(std::move(datum), candidate + why, options.stations.count);
  }
  blankMissing(datum);
  return finishDatum(std::move(datum), options);
}

Datum judgeTests(Datum datum, const DatumOptions& options) {
  const TestOutcome worst = worstOf(datum.tests);
  if (worst == TestOutcome::Pass) return datum;
  const std::string findings = findingsOf(datum.tests);
  const std::string candidate = candidateText(datum.tank.circle, datum.tank.coverage, datum.origin);
  if (worst == TestOutcome::Fail) return endDatum(datum, Status::NoTank, candidate + ", rejected: " + findings);
  const std::string before = std::move(datum.message);
  datum.message =
      (options.accept ? "accepted, though " : candidate + ", doubtful (option accept takes it): ") + findings;
  addClause(datum.message, before);
  if (!options.accept) datum.status = Status::Doubtful;
  return datum;
}

Datum judgeMoreTests(Datum datum, std::vector<TankTest> tests, const DatumOptions& options) {
  std::swap(datum.tests, tests);
  datum = judgeTests(std::move(datum), options);
  datum.tests.insert(datum.tests.begin(), tests.begin(), tests.end());
  return datum;
}

Datum finishDatum(Datum datum, const DatumOptions& options) {
  datum.tilt = fitTilt(datum.stations, datum.circle.center, options.stations, datum.covariance);
  const auto standings = standingsTo(datum.tilt, datum.stations, datum.circle.center);
  datum.stations = withParts(std::move(datum.stations), standings);
  datum.antipodal = antipodalOf(datum.stations);
  datum.status = datum.level.missing == 0 ? Status::Ok : Status::Partial;
  if (datum.level.missing > 0) {
    datum.message = std::to_string(datum.level.missing) + " of " + std::to_string(datum.stations.size()) +
                    " stations are missing: the datum is not measured there";
    addClause(datum.message, sparseFoot(datum.foot_density));
  }
  addClause(datum.message, fineStations(datum.foot_density, options.stations.count));
  addClause(datum.message, doubtfulUnits(datum.circle.radius));
  addClause(datum.message, setupMessage(datum.agreement, datum.stations));
  warnOfSteps(datum);
  return datum;
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

}  // namespace tank_datum
