#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "tank_datum/movement/movement.h"

namespace tank_datum {

/// The options of a comparison as a person types them, in degrees and arc-seconds.
struct TypedMovement {
  std::string removal;
  double tilt_arcsec, offset_deg, correlation_deg;

  explicit TypedMovement(const MovementOptions& options);
  /// The options meant.
  void putInto(MovementOptions& options) const;
};

/// Declares them; both arguments must outlive the parsing.
void addMovementOptions(CLI::App& app, MovementOptions& options, TypedMovement& typed);

}  // namespace tank_datum
