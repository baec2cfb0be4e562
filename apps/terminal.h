#pragma once

namespace tank_datum {

/// Whether standard output is a terminal of a UTF-8 locale, so that block characters show.
bool showsBlocks();

}  // namespace tank_datum
