#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tank_datum/datum.h"

namespace tank_datum {

/// The scanner's setups, what was done to them, and how they agreed; null for stations typed in.
nlohmann::ordered_json setupsSection(const Datum& datum);

/// The stations' covariance, from which a program rebuilds C = diag(independent^2) + factors^T factors; null where it
/// is not known.
nlohmann::ordered_json covarianceSection(const Datum& datum);

/// What the adjustment as a whole says: the sigmas it took, and from where; null for stations typed in.
nlohmann::ordered_json agreementSection(const Datum& datum);

/// The datum with its covariance for finite-element work: a row a node with its place, its settlement (z - mean), its
/// own standard error, and a column a shared error with what one standard deviation of it does to the node [m].
std::string nodesCsv(const Datum& datum);

}  // namespace tank_datum
