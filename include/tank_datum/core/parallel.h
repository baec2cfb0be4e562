#pragma once

#include <cstddef>
#include <functional>

#include "tank_datum/core/export.h"

namespace TANK_DATUM_API tank_datum {

/// How many threads an option means: 0 is all cores.
int threadCount(int threads);

/// Calls work(i) for i = 0 .. count - 1, in any order, from several threads; for templates in headers, whose users need
/// not compile with OpenMP.
/// @param threads  0 means all cores
/// @throws what work throws first; the calls that had not begun are left out
void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace tank_datum
