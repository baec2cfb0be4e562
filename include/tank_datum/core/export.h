#pragma once

/// TANK_DATUM_API is set on the namespace in every header of this folder: the library is compiled with hidden symbols,
/// and what these headers declare is what it shows. TANK_DATUM_API_CLASS is for instantiated templates, where compilers
/// take no standard attribute.
#if defined(__GNUC__)
#define TANK_DATUM_API [[gnu::visibility("default")]]
#define TANK_DATUM_API_CLASS __attribute__((visibility("default")))
#else
#define TANK_DATUM_API
#define TANK_DATUM_API_CLASS
#endif
