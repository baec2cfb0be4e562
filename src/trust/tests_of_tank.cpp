#include "trust/tests_of_tank.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>

#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"

namespace tank_datum {
namespace {

/// The numbers of a test: beyond `doubtful` the thing may be no tank, beyond `fail` it is none.
struct Bounds {
  const char* name;
  const char* unit;
  double doubtful, fail;
};

// A tank is a tank. Every number is free of scale: a share, or measured by what spacing and noise of the scan leave.
//
// behind     A shell is opaque. Walls behind it in the same azimuth, over a tenth of what is seen of it, are what an
//            open tank with a pole in it may show; over a quarter of it they make it a row of other things.
// wall       Sectors in which the wall is seen above the foot, or 0 where no circle fits them; asked where that is too
//            little for what follows. Of 195 simulated tanks it was of none, but of a yard of containers and trees.
// round      Standard deviation of the wall about its circle over what explains it: 0.4 % of the radius (see
//            kOutOfRoundness) and the noise, which counts up to the spacing of the points: what is thicker than that
//            is no single wall. Tins, cans and mugs before depth cameras have 0.2 to 1.5, tanks 0.1 to 0.9, boxes 5,
//            streets and rooms 2 to 9.
// off_circle Share of the azimuths at which the wall is off the circle by more than 2.5 times that and the noise:
//            pipes and stairs hide a tenth of a tank's shell. Cans have 0 to 0.1, streets and rooms 0.3 to 0.9.
// radius     Standard error of the radius over the radius: an arc that knows its circle to a few per cent only may be
//            of anything. Cans of 36 mm, noise 1 mm, have 0.03, a box 0.09.
// cone       Slope of the wall outwards beyond 3 standard errors: a bowl opens by more than 7 degrees and a battered
//            face by 3, a shell of courses that thin upwards by less than 1. Cans and pots on tables have 0.03 at most.
// level      Range of the datum over the diameter, as for waves: of a tank that leans by 1.5 % in a scan by 2 degrees.
// waves      Range of the datum about its plane over the diameter, beyond 6 standard errors of a station and two
//            spacings of the points: a shell buckles at a hundredth of it.
// stations   Least arc that is measured, degrees: a foot seen on 40 degrees has them, and 30 are the shortest wave (n =
//            12) that is looked for in a datum.
// sigma      Standard error of the middle station, without what setups disagree by, over the thickness of the thinnest
//            annular plate: 6 mm, API 650, table 5.1a. What is not known to that does not tell a plate from what it
//            lies on. Of 866 simulated tanks it was beyond that at 4, of which two were measured on soil.
// shell_gap  Height over the datum from which on the wall is seen, beyond three spacings of its points, over how far
//            the section goes. Of bare shells whose foundation is seen beside them it is below 0.05, of tins, cans and
//            mugs before depth cameras below 0.1; cladding ends at 0.2 to 1. No gap makes a tank none.
// under_shell
//            Share of the stations under whose wall the foundation is seen to go on. A shell hides it: there are none.
//            Up to a quarter are left out, and the share is 0; of cladding that ends 10 to 200 mm above it is 0.6 to 1.
// above_shell
//            Share of the stations below which some of the shell is seen, and nothing as low before it. Nothing lies
//            below a foot: of 830 simulated tanks that stand on what was measured the share is 0.015 at most. Of 19
//            whose crown passes for the foot, as wide beams fill the groove behind it, it is 0.025 to 0.16. Strays on
//            one side of the shell, forty pits of a pad, and setups of which a few points lie lower reach that too.
// see_through
//            Azimuths at which ground is seen inside of the circle and no wall, for each at which the wall is: an arc
//            that a shell's circle does not follow, as of an oval building (1.9). A shell is opaque: there are none. An
//            opening of 40 to 70 degrees in one that is seen all round makes 0.12 to 0.24, and what a shell mirrors
//            lies inside too: no such thing makes a tank none.
// raised     How far the stations stand above where the shell is seen elsewhere, over how far that scatters about its
//            plane: a datum is nowhere above what is seen of its shell.
// step       Height of a face that stands out of the wall above it by 20 to 110 mm, all round, over the reach of the
//            section: kerbs and ringwalls that narrow are up to 0.3 m high; plinths, and what clads the lowest part of
//            a shell against fire or hands, a metre and more.
// low_wall   Of a wall up to two metres high, share of what is seen behind whose top something lies. Of a shell in a
//            scan that was cut, or that looks no higher, it is 0; of a ringwall's face, with its top or the lowest
//            centimetres of the shell in view, 0.3 to 1.
constexpr Bounds kBehind{"behind", "1", 0.10, 0.25}, kRound{"round", "1", 1.6, 3.2},
    kOnCircle{"off_circle", "1", 0.25, 0.5}, kRadius{"radius", "1", 0.04, 0.08}, kCone{"cone", "1", 0.05, 0.36},
    kLevel{"level", "1", 0.05, 0.1}, kWaves{"waves", "1", 0.01, 0.02}, kArc{"stations", "deg", 30.0, 15.0},
    kSigma{"sigma", "1", 1.0, HUGE_VAL}, kShellGap{"shell_gap", "1", 0.2, HUGE_VAL},
    kLowWall{"low_wall", "1", 0.1, HUGE_VAL}, kUnderShell{"under_shell", "1", 0.2, HUGE_VAL},
    kAboveShell{"above_shell", "1", 0.03, HUGE_VAL}, kRaised{"raised", "1", 3.0, HUGE_VAL},
    kStep{"step", "1", 0.8, HUGE_VAL}, kWall{"wall", "1", kFewestSectors, -HUGE_VAL},
    kSeeThrough{"see_through", "1", 0.25, HUGE_VAL};

constexpr double kThinnestPlate = 0.006;  // [footUnit]

__attribute__((format(printf, 3, 4))) TankTest judged(const Bounds& bounds, double value, const char* format, ...) {
  TankTest test;
  test.name = bounds.name;
  test.unit = bounds.unit;
  test.value = value;
  test.limit = bounds.doubtful;
  const bool at_least = bounds.fail < bounds.doubtful;
  const auto beyond = [&](double limit) { return at_least ? value < limit : value > limit; };
  test.outcome = beyond(bounds.fail)       ? TestOutcome::Fail
                 : beyond(bounds.doubtful) ? TestOutcome::Doubtful
                                           : TestOutcome::Pass;
  std::va_list values;
  va_start(values, format);
  test.finding = vformatted(format, values);
  va_end(values);
  return test;
}

double rangeAboutPlane(const std::vector<Station>& stations) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) low = std::min(low, s.u), high = std::max(high, s.u);
  }
  return std::max(0.0, high - low);
}

/// The median of what sigmaOf says of the measured stations; NaN where none is known.
template <typename SigmaOf>
double medianSigma(const std::vector<Station>& stations, const SigmaOf& sigmaOf) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) sigmas.push_back(sigmaOf(s));
  }
  return median(finiteOf(sigmas));
}

}  // namespace

std::vector<TankTest> testsOfGap(double shell_from, double reach, const ShellEvidence& shell) {
  if (!std::isfinite(shell_from) || !shell.known()) return {};
  return {judged(kShellGap, std::max(0.0, shell_from - 3.0 * shell.spacing) / reach,
                 "its wall is seen from %.3g m above the foundation on, as of cladding, a dark foot or a tank on beams",
                 shell_from)};
}

std::vector<TankTest> testsUnderShell(double under_shell) {
  if (!std::isfinite(under_shell)) return {};
  return {judged(kUnderShell, under_shell,
                 "the foundation is seen under its wall over %.0f %% of the foot, as under cladding or a tank on beams",
                 100.0 * under_shell)};
}

std::vector<TankTest> testsAboveShell(double above_shell) {
  if (!std::isfinite(above_shell)) return {};
  return {judged(
      kAboveShell, above_shell,
      "its shell is seen below what it stands on at %.0f %% of the stations, and nothing before it, as behind a crown",
      100.0 * above_shell)};
}

std::vector<TankTest> testsOfRaised(double raised) {
  if (!std::isfinite(raised)) return {};
  return {judged(kRaised, std::max(0.0, raised),
                 "what it is measured on stands above where its shell is seen elsewhere, by %.1f times how far that "
                 "scatters, as soil against it does",
                 raised)};
}

std::vector<TankTest> testsOfStep(double width, double height, double reach) {
  if (!(height > 0.0)) return {};
  return {
      judged(kStep, height / reach,
             "its wall steps back by %.2g m, %.1f m above the ground, as a shell upon a plinth does and one that is "
             "clad below: option tank with the circle of its shell tells which",
             width, height)};
}

std::vector<TankTest> testsOfGround(double ground_inside) {
  if (!std::isfinite(ground_inside)) return {};
  return {judged(kSeeThrough, ground_inside,
                 "ground is seen inside its circle where its wall is not, over %.2f times what is seen of it",
                 ground_inside)};
}

std::vector<TankTest> testsOfShell(const Tank& tank, const ShellEvidence& shell) {
  std::vector<TankTest> tests;
  tests.push_back(judged(kBehind, tank.behind_share, "walls lie %.3g m behind it over %.0f %% of what is seen of it",
                         tank.behind, 100.0 * tank.behind_share));
  if (std::isfinite(tank.low_wall)) {
    tests.push_back(
        judged(kLowWall, tank.low_wall,
               "its wall is %.1f m high only, and something lies behind its top, as behind a ringwall's or a planter's",
               tank.height));
  }
  if (!shell.known()) {
    const double sectors = shell.sectors < kFewestSectors ? static_cast<double>(shell.sectors) : 0.0;  // of no circle
    tests.push_back(
        judged(kWall, sectors, "too little of its wall is seen above its foot to tell whether that is round"));
    return tests;
  }
  const double radius = shell.circle.radius;
  const double explained = std::hypot(kOutOfRoundness * radius, std::min(shell.noise, shell.spacing));
  tests.push_back(judged(kRound, shell.off_round / explained,
                         "its wall is off the circle by %.3g m RMS, where noise and out-of-roundness explain %.3g m",
                         shell.off_round, explained));
  tests.push_back(judged(kOnCircle, 1.0 - shell.on_circle, "its wall is off the circle over %.0f %% of what is seen",
                         100.0 * (1.0 - shell.on_circle)));
  tests.push_back(judged(kRadius, shell.sigma_radius / radius, "the arc knows its radius to %.1f %% only",
                         100.0 * shell.sigma_radius / radius));
  if (std::isfinite(shell.cone)) {
    tests.push_back(judged(kCone, std::max(0.0, std::abs(shell.cone) - 3.0 * shell.sigma_cone),
                           "its wall is a cone that opens by %.0f deg",
                           std::abs(toDegrees(portable::atan(shell.cone)))));
  }
  return tests;
}

std::vector<TankTest> testsOfStations(const std::vector<Station>& stations, const Level& level, const Tilt& tilt,
                                      const ShellEvidence& shell) {
  std::vector<TankTest> tests;
  const double arc = 360.0 * static_cast<double>(level.measured) / static_cast<double>(stations.size());
  tests.push_back(judged(kArc, arc, "its foot is measured over %.0f deg only", arc));
  if (!tilt.valid() || !shell.known()) return tests;
  const double diameter = 2.0 * shell.circle.radius;
  const double sigma = medianSigma(stations, [](const Station& s) { return s.sigma_z; });
  const double unknown = 6.0 * (std::isfinite(sigma) ? sigma : shell.noise) + 2.0 * shell.spacing;
  const double range = level.range(), about_plane = rangeAboutPlane(stations);
  tests.push_back(
      judged(kLevel, std::max(0.0, range - unknown) / diameter, "its foot rises by %.3g m from side to side", range));
  tests.push_back(judged(kWaves, std::max(0.0, about_plane - unknown) / diameter,
                         "its foot is out of plane by %.3g m, which no tank survives", about_plane));
  return tests;
}

std::vector<TankTest> testsOfSigma(const std::vector<Station>& stations, double unit) {
  const double sigma = medianSigma(stations, [](const Station& s) {
    const double of_setups = std::isfinite(s.sigma_setup) ? s.sigma_setup : 0.0;
    return std::sqrt(std::max(square(s.sigma_z) - square(of_setups), 0.0));  // unknown stays unknown
  });
  if (!std::isfinite(sigma)) return {};
  const double plate = kThinnestPlate * unit;
  return {judged(kSigma, sigma / plate,
                 "its stations are known to %.2g m only (1 sigma, median), and a plate may be %.2g m thick: on which "
                 "surface it stands is not told",
                 sigma, plate)};
}

std::vector<std::size_t> stationsOffCircle(const std::vector<Station>& stations, const Circle& circle,
                                           const ShellEvidence& shell) {
  std::vector<std::size_t> off;
  if (!shell.known() || !circle.valid()) return off;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& s = stations[i];
    if (s.flag != StationFlag::Measured || !std::isfinite(s.radius)) continue;
    const double sigma = std::isfinite(s.sigma_radius) ? s.sigma_radius : 0.0;
    const double most =
        3.0 * std::hypot(std::max(kOutOfRoundness * circle.radius, shell.off_round), shell.noise, sigma);
    if (std::abs(s.radius - circle.radius) > most) off.push_back(i);
  }
  return off;
}

}  // namespace tank_datum
