#pragma once

#include "tank_datum/search/bucket_tree.h"
#include "tank_datum/search/normals.h"

namespace tank_datum {

/// Where the neighbours of all points go.
struct NeighbourRows {
  int k = 0;
  int threads = 0;                ///< 0 means all cores
  std::int32_t* first = nullptr;  ///< a row of k for every point
};

/// The k nearest of every point, nearest first, as the engine finds them among the points rounded to float32.
/// @param points  at least rows.k
/// @param done    told, from several threads, whose rows are filled
void findRows(SearchEngine engine, const Points& points, const NeighbourRows& rows, const BucketTree::RowsDone& done);

}  // namespace tank_datum
