#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "tank_datum/io/scan.h"
#include "tank_datum/locate/tank.h"

namespace tank_datum {

/// So many setups a ring can tell apart; of a scan with more, the points' setups are not known.
constexpr std::size_t kMostSetups = 200;

/// Thins the points by voxels into ring.search; again after they were moved.
void thinForSearch(Ring& ring, const Tank& tank, const CropOptions& options, int threads = 0);

/// Gathers a part of the scan beside the ring: told each block of it that is looked at, from several threads.
using AlsoGathered = std::function<void(std::uint64_t n, const Points& block)>;

/// Of a larger scan at least so many points are looked at: what is gathered beside the ring, the shell, may be sparse
/// where the foot is dense.
constexpr std::uint64_t kPointsLookedAt = 30'000'000;

/// How far from the shell and from the coarse foot points of the ring lie at most: the reach, enlarged by the accuracy
/// of the coarse figures [m].
double widestReach(const Tank& tank, const CropOptions& options);

/// Every which row of a scan is looked at for a ring: 1, unless the scan is large and the ring holds several times what
/// is kept for the fits.
std::uint64_t rowStride(const Scan& scan, const Tank& tank, const CropOptions& options);

/// Keeps the points whose distance from the shell and from the coarse foot is at most the reach (enlarged by the
/// accuracy of the coarse figures). Of more than options.fit_points, those are kept whose hash is lowest, so that
/// memory and the time of the fits are bounded; where there are several times as many, every n-th row is looked at
/// only. Up to there the result does not depend on the order of the points.
/// A ring of several setups has its search points only after thinForSearch: they are adjusted to each other first.
/// @param also     another part of the scan, gathered in the same pass: a scan is long to read
/// @param threads  0 means all cores; the ring does not depend on it
Ring cropRing(const Scan& scan, const Tank& tank, const CropOptions& options, const AlsoGathered& also = nullptr,
              int threads = 0);

}  // namespace tank_datum
