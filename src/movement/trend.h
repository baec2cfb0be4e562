#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// What surveys scatter by about a line: of a normal distribution, or where it is more than their errors explain
/// (chi-square, 95 %) of that scatter itself.
struct LineScatter {
  double variance = 1.0;  ///< of the line's errors, times what those of the surveys make of it
  double freedom = 0.0;   ///< of Student's t; 0: the normal distribution
};

/// @param misfit   sum of the squares of residuals over standard errors
/// @param freedom  residuals beyond two
LineScatter scatterAbout(double misfit, double freedom);

/// The time of a day that there is [years].
double yearOf(int year, int month, int day);

/// The time of a date as "2024-05-31" or a decimal year as "2024.41" [years].
/// @throws Error (Option) for anything else, a date that there is not included
double yearOf(const std::string& date);

/// The times of so many surveys: of their dates [years], or without any their numbers.
/// @throws Error (Option) as yearOf
std::vector<double> timesOf(const std::vector<std::string>& dates, std::size_t surveys);

/// Refuses surveys whose own dates say that one is of an earlier day than the one before it; dates that cannot be read
/// say nothing.
/// @throws Error (Option)
void requireInOrder(const std::vector<Epoch>& surveys);

}  // namespace tank_datum
