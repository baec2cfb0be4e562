#pragma once

#include "foot_frame.h"
#include "tank_datum/datum.h"

namespace tank_datum {

/// Tells that a stage begins, where somebody wants to know.
void tell(const Callbacks& callbacks, const char* stage);

/// The stages at the foot, from the ring of the tank to its stations, of a shell that may lean and a ring in any units;
/// in the scan's frame.
FootResult measureFoot(const Ring& ring, const Tank& tank, const ShellLean& lean, const DatumOptions& options,
                       const Callbacks& callbacks);

}  // namespace tank_datum
