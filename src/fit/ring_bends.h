#pragma once

#include <vector>

#include "fit/ring_filter.h"

namespace tank_datum {

/// A ring may bend in one place as it does nowhere else, where the process that is likeliest of the whole ring smooths
/// what the values show. At every place each of several processes counts by how likely the values within five degrees
/// are under it, each by what the others say (Bayesian model averaging: Hoeting, Madigan,
/// Raftery and Volinsky 1999), and what the processes differ by is in the standard error. Where none is within reach
/// the usual process stands.
/// @param usual         the process that is likeliest of the whole ring
/// @param alternatives  what it may be instead at any place, together once in e^6 times
/// @param result        `value` and `sigma` of the usual process; becomes those of all, with `bent`
void followBends(const RingData& data, const ProcessParameters& usual,
                 const std::vector<ProcessParameters>& alternatives, RingProcess& result);

}  // namespace tank_datum
