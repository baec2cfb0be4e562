#pragma once

#include <vector>

#include "io/record_rows.h"

namespace tank_datum {

/// Reads and checks the header of a LAS file of version 1.0 to 1.4 and tells where its points are: x, y and z by scale
/// and offset, the point source id as label. Source: ASPRS, LAS Specification 1.4-R15.
///
/// Points marked as withheld are no points: the specification calls that synonymous with deleted.
/// @param classes  classification codes of the points that are wanted; empty: all
/// @throws Error (File) when the header is none, is not consistent with itself or asks for more points than the file
///         has, naming both counts
RecordRows readLasHeader(const InputFile& file, const std::vector<int>& classes);

}  // namespace tank_datum
