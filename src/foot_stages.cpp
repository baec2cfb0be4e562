#include "foot_stages.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "core/parts.h"
#include "fit/spline.h"
#include "foot/refine.h"
#include "refusals.h"
#include "stations/stations.h"
#include "tank_datum/edge/find_edge_points.h"
#include "tank_datum/search/estimate_normals.h"

namespace tank_datum {
namespace {

Points pointsAt(const Points& points, const std::vector<std::int32_t>& indices) {
  Points chosen;
  for (const std::int32_t i : indices) chosen.push_back(points[static_cast<std::size_t>(i)]);
  return chosen;
}

/// The stages at the foot, from the ring of the tank to its stations.
FootResult measureUprightFoot(const Ring& ring, const Tank& tank, const DatumOptions& options,
                              const Callbacks& callbacks) {
  FootResult foot;
  tell(callbacks, "normals");
  Normals normals = callbacks.normals ? callbacks.normals(ring.search, options.normals, options.threads)
                                      : estimateNormals(ring.search, options.normals, options.threads);
  tell(callbacks, "region_growing");
  const auto candidates = growCandidates(normals, options.growing, options.threads);
  tell(callbacks, "centre_filter");
  const EdgePoints edge = filterByCentre(ring.search, candidates, tank.circle, options.centre_filter);
  foot.edge = edge.indices;
  foot.edge_points = pointsAt(ring.search, foot.edge);
  tell(callbacks, "spline");
  foot.curve = fitClosedSpline(foot.edge_points, edge.azimuths, options.spline);
  if (!foot.curve.valid()) foot.note = "no paper's curve: " + whyNoCurve(normals, candidates, edge);
  foot.stations = emptyStations(options.stations);
  if (foot.curve.valid()) {
    foot.stations = withParts(foot.stations, samplePaperCurve(foot.stations, foot.curve, edge, options.stations));
    for (Station& s : foot.stations) s.z_paper = s.z;
  }
  foot.circle = edge.circle;
  normals = {};  // refining holds the ring in other orders
  tell(callbacks, "refine");
  if (options.method == Method::Paper) return foot;
  RefinedFoot refined = refineStations(ring, tank, options.refine, options.stations);
  foot.stations = withParts(foot.stations, refined.stations);
  foot.refined = std::move(refined.refined);
  foot.circle = foot.refined.circle;
  return foot;
}

}  // namespace

void tell(const Callbacks& callbacks, const char* stage) {
  if (callbacks.stage) callbacks.stage(stage);
}

FootResult measureFoot(const Ring& ring, const Tank& tank, const ShellLean& lean, const DatumOptions& options,
                       const Callbacks& callbacks) {
  const FootFrame frame(tank, lean);
  if (frame.isScans()) return measureUprightFoot(ring, tank, options, callbacks);
  Callbacks in_frame{callbacks.stage, {}, {}};
  if (callbacks.normals) {
    in_frame.normals = [&](const Points&, const NormalOptions& asked, int threads) {
      return callbacks.normals(ring.search, asked, threads);  // of the scan's own points, which it may know
    };
  }
  FootResult foot = measureUprightFoot(frame.into(ring), frame.into(tank), options, in_frame);
  frame.backFrom(foot);
  foot.edge_points = pointsAt(ring.search, foot.edge);
  return foot;
}

}  // namespace tank_datum
