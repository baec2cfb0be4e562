#pragma once

#include <cstddef>
#include <vector>

#include "tank_datum/fit/curves.h"
#include "tank_datum/locate/tank.h"
#include "tank_datum/shape/analysis.h"
#include "tank_datum/stations/stations.h"
#include "tank_datum/trust/tank_tests.h"
#include "trust/shell_evidence.h"

namespace tank_datum {

/// Where each test's numbers come from stands in the table of tests_of_tank.cpp.
std::vector<TankTest> testsOfShell(const Tank& tank, const ShellEvidence& shell);

/// @param ground_inside  groundInside(); none of what is not known
std::vector<TankTest> testsOfGround(double ground_inside);

/// The tests of what was measured at the foot.
std::vector<TankTest> testsOfStations(const std::vector<Station>& stations, const Level& level, const Tilt& tilt,
                                      const ShellEvidence& shell);

/// Whether the stations are known well enough to tell surfaces apart; none where no sigma is known.
/// @param unit  footUnit of the tank [m]
std::vector<TankTest> testsOfSigma(const std::vector<Station>& stations, double unit);

/// Whether the shell is seen down to its foot; none where that is not known.
/// @param shell_from  height above the datum from which on it is seen [m]
/// @param reach       of the section of the foot [m]
std::vector<TankTest> testsOfGap(double shell_from, double reach, const ShellEvidence& shell);

/// Whether the foundation ends at the shell; none where that is not known.
/// @param under_shell  share of the stations at which it is seen under the wall
std::vector<TankTest> testsUnderShell(double under_shell);

/// Whether the shell ends where it was measured; none where that is not known.
/// @param above_shell  share of the stations below which some of it is seen, and nothing as low before it
std::vector<TankTest> testsAboveShell(double above_shell);

/// @param raised  how far the stations stand above where the shell is seen elsewhere, over how far that scatters
std::vector<TankTest> testsOfRaised(double raised);

/// Whether the shell begins at the step on which it was measured, or not at the step above it; none where there is no
/// such step.
/// @param width,height  of the face below the step: how far it stands out, and down to the ground [m]
/// @param reach         of the section of the foot [m]
std::vector<TankTest> testsOfStep(double width, double height, double reach);

/// Numbers of the measured stations that do not lie on their shell, whose elevation is another thing's.
std::vector<std::size_t> stationsOffCircle(const std::vector<Station>& stations, const Circle& circle,
                                           const ShellEvidence& shell);

}  // namespace tank_datum
