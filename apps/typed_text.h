#pragma once

#include <string>
#include <vector>

#include "tank_datum/fit/curves.h"

namespace tank_datum {

/// What people type as text. `flag` is named when it cannot be read.
/// @throws Error (Option)

/// A length as "8", "8m", "26.25 ft", "315in", "8000mm" [m]; a number alone is metres.
double lengthFrom(const std::string& flag, const std::string& typed);
/// "X,Y,R" [m]
Circle circleFrom(const std::string& flag, const std::string& typed);
/// "H,H,..."; none of an empty text.
std::vector<double> numbersFrom(const std::string& flag, const std::string& typed);
/// "C,C,...", whole numbers; none of an empty text.
std::vector<int> codesFrom(const std::string& flag, const std::string& typed);
/// "A,B,..." without the blanks around; none of an empty text.
std::vector<std::string> namesFrom(const std::string& flag, const std::string& typed);

}  // namespace tank_datum
