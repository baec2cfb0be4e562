#include "truth_shell.h"

#include <cmath>

#include "core/portable_math.h"
#include "fit/circle.h"

namespace tank_datum::synth {
namespace {

constexpr double kFirst = 0.3, kStep = 1.0;  ///< heights above the datum [m]

double azimuthOf(int station, int stations) { return 2.0 * kPi * station / stations; }

TruthRound roundAt(const Tank& tank, double height, int stations, const Eigen::Vector2d& offset, bool inside) {
  const TankOptions& o = tank.shape.options();
  std::vector<Eigen::Vector2d> plan;
  for (int k = 0; k < stations; ++k) {
    plan.push_back(tank.shellPoint(azimuthOf(k, stations), height, inside).head<2>());
  }
  const Circle circle = fitCircle(plan, {}, {{o.x, o.y}, o.radius});
  TruthRound round;
  round.height = height;
  round.x = circle.center.x() + offset.x(), round.y = circle.center.y() + offset.y();
  round.radius = circle.radius;
  for (int k = 0; k < stations; ++k) {
    const double deviation = circle.residual(plan[static_cast<std::size_t>(k)]);
    if (std::abs(deviation) > std::max(round.max_deviation, -round.min_deviation)) {
      round.azimuth = azimuthOf(k, stations);
    }
    round.max_deviation = std::max(round.max_deviation, deviation);
    round.min_deviation = std::min(round.min_deviation, deviation);
  }
  return round;
}

}  // namespace

void addShellTruth(const Tank& tank, int stations, const Eigen::Vector2d& offset, TruthTank& truth) {
  const TankOptions& o = tank.shape.options();
  truth.lean = tank.shape.lean();
  double top = kFirst;
  for (double height = kFirst; height < o.height; height += kStep) {
    truth.rounds.push_back(roundAt(tank, height, stations, offset, truth.inside));
    top = height;
  }
  truth.plumb.height = top - kFirst;
  for (int k = 0; k < stations; ++k) {
    const double azimuth = azimuthOf(k, stations);
    const Eigen::Vector2d centre(o.x, o.y);
    const auto radius = [&](double height) {
      return (tank.shellPoint(azimuth, height, truth.inside).head<2>() - centre).norm();
    };
    const double off = radius(top) - radius(kFirst);
    if (std::abs(off) > std::abs(truth.plumb.offset)) truth.plumb.offset = off, truth.plumb.azimuth = azimuth;
  }
}

nlohmann::ordered_json shellTruthJson(const TruthTank& tank) {
  nlohmann::ordered_json roundness = nlohmann::ordered_json::array();
  for (const TruthRound& r : tank.rounds) {
    roundness.push_back({{"height", r.height},
                         {"center", {r.x, r.y}},
                         {"radius", r.radius},
                         {"max_deviation", r.max_deviation},
                         {"min_deviation", r.min_deviation},
                         {"azimuth_deg", degrees(r.azimuth)}});
  }
  const double direction = degrees(portable::atan2(tank.lean.y(), tank.lean.x()));
  return {{"roundness", roundness},
          {"plumbness_max", std::abs(tank.plumb.offset)},
          {"plumbness_height", tank.plumb.height},
          {"plumbness_azimuth_deg", degrees(tank.plumb.azimuth)},
          {"lean", {{"slope", tank.lean.norm()}, {"direction_deg", direction < 0.0 ? direction + 360.0 : direction}}}};
}

}  // namespace tank_datum::synth
