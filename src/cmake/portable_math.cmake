# Sines, logarithms and the like from SLEEF, in which every processor computes alike: src/core/portable_math.cpp. The
# linker puts them in the C library's place, for Eigen's and PCL's templates too.
find_library(SLEEF_LIBRARY sleef REQUIRED)
set(TANK_DATUM_PORTABLE_MATH)
foreach(function sin cos tan asin acos atan atan2 exp exp2 log log2 log10 log1p pow hypot cbrt erfc sincos sinf cosf sincosf
        atan2f)
  list(APPEND TANK_DATUM_PORTABLE_MATH LINKER:--wrap=${function})
endforeach()
