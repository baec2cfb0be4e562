#pragma once

#include "shape/second_differences.h"
#include "stations/ring_rows.h"

namespace tank_datum {

/// Rows of the second differences between survey points, scaled by (spacing / L)^2 as their limits are.
/// @param series  of U
RingRows secondDifferenceRows(const RingSeries& series, const SurveyPlan& plan, double radius);

/// Rows of DeBeer's distortion S / l, l the mean of the two arcs.
RingRows distortionRows(const RingSeries& series, const SurveyPlan& plan, double radius);

/// Rows of the height between neighbouring survey points over their arc [m/m].
/// @param series  of z
RingRows neighbourRows(const RingSeries& series, const SurveyPlan& plan, double radius);

}  // namespace tank_datum
