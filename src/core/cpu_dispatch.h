#pragma once

/// Before a function of plain arrays: it is compiled for AVX2 too, and the program chooses when it starts.
// an address sanitizer's shadow is not there yet when the program chooses
#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define TANK_DATUM_CPU_DISPATCH __attribute__((target_clones("avx2", "default")))
#else
#define TANK_DATUM_CPU_DISPATCH
#endif
