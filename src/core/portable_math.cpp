// The C library's functions in the place of which the linker puts those of SLEEF (cmake/portable_math.cmake). The C
// library chooses by the processor how it computes them, and the last bit of a result follows the choice: with fused
// multiply-add it is another. These compute alike on every processor.
#include <sleef.h>

// The names are those that the linker's option --wrap gives.
extern "C" {

double __wrap_sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
double __wrap_cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
double __wrap_tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
double __wrap_asin(double x) { return Sleef_cinz_asind1_u10purec(x); }
double __wrap_acos(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double __wrap_atan(double x) { return Sleef_cinz_atand1_u10purec(x); }
double __wrap_atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double __wrap_exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double __wrap_exp2(double x) { return Sleef_cinz_exp2d1_u10purec(x); }
double __wrap_log(double x) { return Sleef_cinz_logd1_u10purec(x); }
double __wrap_log2(double x) { return Sleef_cinz_log2d1_u10purec(x); }
double __wrap_log10(double x) { return Sleef_cinz_log10d1_u10purec(x); }
double __wrap_log1p(double x) { return Sleef_cinz_log1pd1_u10purec(x); }
double __wrap_pow(double x, double y) { return Sleef_cinz_powd1_u10purec(x, y); }
double __wrap_hypot(double x, double y) { return Sleef_cinz_hypotd1_u05purec(x, y); }
double __wrap_cbrt(double x) { return Sleef_cinz_cbrtd1_u10purec(x); }
double __wrap_erfc(double x) { return Sleef_cinz_erfcd1_u15purec(x); }

void __wrap_sincos(double x, double* sine, double* cosine) {
  const Sleef_double_2 both = Sleef_cinz_sincosd1_u10purec(x);
  *sine = both.x;
  *cosine = both.y;
}

void __wrap_sincosf(float x, float* sine, float* cosine) {
  const Sleef_float_2 both = Sleef_cinz_sincosf1_u10purec(x);
  *sine = both.x;
  *cosine = both.y;
}

float __wrap_sinf(float x) { return Sleef_cinz_sinf1_u10purec(x); }
float __wrap_cosf(float x) { return Sleef_cinz_cosf1_u10purec(x); }
float __wrap_atan2f(float y, float x) { return Sleef_cinz_atan2f1_u10purec(y, x); }
}
