#pragma once

namespace tank_datum {

/// The C library chooses by the processor how it computes sines, logarithms and the like, and the last bit of a result
/// follows the choice: with fused multiply-add it is another. These are computed alike on every processor, within one
/// unit in the last place (erfc 1.5, atan2 3.5). Angles are in radians. Square roots, remainders and roundings are
/// exact in the C library, its hypot has one form.
namespace portable {

struct SineCosine {
  double sine;
  double cosine;
};

double sin(double x);
double cos(double x);
/// Both at once, in two thirds of the time of one after the other.
SineCosine sinCos(double x);
double asin(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double exp2(double x);
double log(double x);
double log1p(double x);
double log2(double x);
double log10(double x);
double pow(double base, double exponent);
double cbrt(double x);
double erf(double x);
double erfc(double x);

}  // namespace portable

inline double square(double x) { return x * x; }

}  // namespace tank_datum
