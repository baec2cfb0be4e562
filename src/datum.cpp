#include "tank_datum/datum.h"

#include <algorithm>

#include "tank_datum/error.h"

namespace tank_datum {
namespace {

Datum stopped(Datum datum, Status status, const std::string& message) {
  datum.status = status;
  datum.message = message;
  datum.stations.clear();
  return datum;
}

void requireValid(const DatumOptions& options) {
  const std::string error = firstError(options);
  const auto equals = error.find(" = "), must = error.find(" (must be ");
  if (error.empty()) return;
  throw Error(Error::Kind::Option, "options", error.substr(0, equals), error.substr(equals + 3, must - equals - 3),
              error.substr(must + 10, error.size() - must - 11));
}

/// Stations whose z is known, and what they mean.
void describe(Datum& datum, const DatumOptions& options) {
  datum.level = levelOf(datum.stations);
  datum.tilt = fitTilt(datum.stations, datum.circle.center, options.stations);
  datum.antipodal = antipodalOf(datum.stations);
  datum.status = datum.level.missing == 0 ? Status::Ok : Status::Partial;
  if (datum.level.missing > 0) {
    datum.message = std::to_string(datum.level.missing) + " of " + std::to_string(datum.stations.size()) +
                    " stations are missing: the datum is not seen there";
  }
}

}  // namespace

std::string firstError(const DatumOptions& options) {
  for (const std::string& error :
       {firstError(options.locate), firstError(options.crop), firstError(options.normals), firstError(options.growing),
        firstError(options.centre_filter), firstError(options.spline), firstError(options.stations)}) {
    if (!error.empty()) return error;
  }
  if (options.tank && !(options.tank->radius > 0.0)) {
    return "tank.radius = " + std::to_string(options.tank->radius) + " (must be > 0)";
  }
  if (options.threads < 0) return "threads = " + std::to_string(options.threads) + " (must be >= 0)";
  return {};
}

Datum extractDatum(const Scan& scan, const DatumOptions& options, const StageObserver& observer) {
  requireValid(options);
  if (observer) observer("locate");
  const std::vector<Tank> tanks = locateTanks(scan, options.locate);
  if (tanks.empty()) {
    return stopped({}, Status::NoTank, "no vertical cylinder of the smallest radius or more stands in the scan");
  }
  return extractDatumOf(tanks.front(), scan, options, observer);
}

Datum extractDatumOf(const Tank& tank, const Scan& scan, const DatumOptions& options, const StageObserver& observer) {
  requireValid(options);
  const auto begin = [&](const char* stage) { if (observer) observer(stage); };
  Datum datum;
  datum.origin = scan.origin();
  datum.tank = tank;
  if (!tank.has_foundation) return stopped(datum, Status::NoCrease, "no surface meets the foot of the shell");

  begin("crop");
  const Ring ring = cropRing(scan, tank, options.crop);
  datum.counts = ring.counts;
  if (ring.points.size() < static_cast<std::size_t>(options.normals.k)) {
    return stopped(datum, Status::TooFewPoints, "fewer points near the datum than neighbours asked for");
  }
  begin("normals");
  const Normals normals = estimateNormals(ring.points, options.normals, options.threads);
  begin("region_growing");
  const auto candidates = growCandidates(normals, options.growing, options.threads);
  begin("centre_filter");
  const EdgePoints edge = filterByCentre(ring.points, candidates, tank.circle, options.centre_filter);
  for (const auto i : edge.indices) datum.edge_points.push_back(ring.points[static_cast<std::size_t>(i)]);
  begin("spline");
  datum.circle = edge.circle;
  datum.curve = fitClosedSpline(datum.edge_points, edge.azimuths, options.spline);
  if (!datum.curve.valid()) return stopped(datum, Status::FitFailed, "too few edge points for a closed curve");
  begin("stations");
  datum.stations = emptyStations(options.stations);
  samplePaperCurve(datum.stations, datum.curve, edge, options.stations);
  begin("deformation");
  describe(datum, options);
  return datum;
}

}  // namespace tank_datum
