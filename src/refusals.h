#pragma once

#include <string>

#include "tank_datum/datum.h"

namespace tank_datum {

/// "circle found, R 34.6 m at 12.3, -4.5, seen over 164 deg"
std::string candidateText(const Circle& circle, double coverage, const Eigen::Vector3d& origin);

/// Why no tank stands in a scan, in which the best candidate is named, and the axis along which one does stand.
/// @param tried  where to put that candidate's circle
std::string whyNoTank(const Scan& scan, const DatumOptions& options, Circle& tried);

/// ": along y stands a cylinder of R 5 m: is that up (option up y)?", or nothing when there is none along another axis
/// than z.
std::string otherAxis(const Scan& scan, const DatumOptions& options);

/// Why there is no curve through the edge points.
std::string whyNoCurve(const Normals& normals, const std::vector<std::int32_t>& candidates, const EdgePoints& edge);

/// A question where a radius is no tank's: "R = 10670 m: is the scan in mm?", or in ft; else nothing.
std::string doubtfulUnits(double radius);

/// "shell and foundation lean together by 0.52 deg towards 120 deg (...)", or "the shell leans by ..."; nothing where
/// the lean is small or not known.
std::string leanText(const Datum& datum, const StationOptions& options);

/// On what a shell stands that was taken to begin where its wall steps back; empty where it was not.
std::string ringwallText(const Tank& tank);

}  // namespace tank_datum
