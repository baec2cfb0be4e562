#pragma once

/// Set on the namespace in every header of this folder: the library is compiled with hidden symbols, and what these
/// headers declare is what it shows.
#if defined(__GNUC__)
#define TANK_DATUM_API __attribute__((visibility("default")))
#else
#define TANK_DATUM_API
#endif
