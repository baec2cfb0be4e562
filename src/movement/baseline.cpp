#include "movement/baseline.h"

#include <cmath>
#include <optional>
#include <utility>

#include "movement/movement.h"
#include "movement/same_tank.h"
#include "tank_datum/core/error.h"
#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {
namespace {

/// The options with tolerances that allow for a coarser circle.
MovementOptions looseTolerances(MovementOptions options, double by) {
  options.radius_difference += by;
  options.centre_distance += by;
  return options;
}

}  // namespace

Baseline readBaseline(const std::string& path, const MovementOptions& options, const DatumOptions& current) {
  requireValid(options);
  return baselineOf(readEpoch(path), options, current);
}

Baseline baselineOf(Epoch survey, const MovementOptions& options, const DatumOptions& current) {
  requireValid(options);
  Baseline baseline{std::move(survey), options};
  const Epoch& epoch = baseline.epoch;
  if (!epoch.usable()) {
    throw Error(Error::Kind::Option, "movement", "baseline", epoch.name + " of status " + epoch.status,
                "a result with a usable datum");
  }
  if (current.method == Method::Paper) {
    throw Error(Error::Kind::Option, "movement", "method", "paper",
                "refined: the paper's elevations have no standard errors");
  }
  if (epoch.method != nameOf(current.method)) {
    throw Error(Error::Kind::Option, "movement", "baseline", epoch.name + " of method " + epoch.method,
                std::string("the method of this survey, ") + nameOf(current.method));
  }
  requireErrors(epoch);
  if (current.tank) requireSameTank(epoch, "option tank", *current.tank, looseTolerances(options, current.crop.reach));
  return baseline;
}

void requireAmong(const std::vector<Tank>& tanks, const Eigen::Vector3d& origin, const Baseline& baseline) {
  std::optional<Error> refusal;
  double least = INFINITY;
  for (const Tank& tank : tanks) {
    const Circle circle{tank.circle.center + origin.head<2>(), tank.circle.radius};
    try {
      requireSameTank(baseline.epoch, "the tank in the scan", circle,
                      looseTolerances(baseline.options, 2.0 * tank.resolution));
      return;
    } catch (const Error& error) {
      const double unlike = std::abs(circle.radius - baseline.epoch.circle.radius);
      if (unlike < least) least = unlike, refusal = error;
    }
  }
  if (refusal) throw *refusal;
}

Movement movementSince(const Baseline& baseline, const Datum& datum, const DatumOptions& current) {
  return compareEpochs(baseline.epoch, epochOf(datum, current.method, "this survey"), baseline.options);
}

}  // namespace tank_datum
