#pragma once

namespace tank_datum {

/// Usual distance of survey points along a shell, 20 ft [m]: API 653 B.2.2 asks for 32 ft at most and eight points. An
/// arc without elevations that is wider may hide what would fail, and a wave whose half is shorter is not surveyed.
constexpr double kSurveySpacing = 6.096;

/// The code's own bound of that distance, 32 ft [m]: the widest gap of a levelling whose points stand further apart
/// than usual.
constexpr double kWidestSpacing = 9.7536;

/// The widest gap between points that people chose, so far apart as a rule [m]. What lies between the stations of a
/// scan is in the scan: their gap is kSurveySpacing.
inline double widestLevelledGap(double spacing) { return spacing > kSurveySpacing ? kWidestSpacing : kSurveySpacing; }

}  // namespace tank_datum
