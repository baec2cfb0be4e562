#pragma once

#include <nlohmann/json.hpp>

#include "tank_datum/datum.h"

namespace tank_datum {

/// The scanner's setups, what was done to them, and how they agreed; null for stations typed in.
nlohmann::ordered_json setupsSection(const Datum& datum);

/// The stations' covariance, from which a program rebuilds C = diag(independent^2) + factors^T factors; null where it
/// is not known.
nlohmann::ordered_json covarianceSection(const Datum& datum);

/// What the adjustment as a whole says: the sigmas it took, and from where; null for one setup.
nlohmann::ordered_json agreementSection(const Datum& datum);

}  // namespace tank_datum
