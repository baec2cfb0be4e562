#include "core/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tank_datum::portable_math_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Function {
  const char* name;
  double (*portable)(double);
  long double (*exact)(long double);
  double low, high;
  bool decades = false;  ///< arguments are 10 to the power of what is drawn
  double units = 1.0;    ///< of the last place, at most
};

const Function kFunctions[] = {
    {"sin", portable::sin, std::sin, -100.0, 100.0},
    {"cos", portable::cos, std::cos, -100.0, 100.0},
    {"sin of much", portable::sin, std::sin, -1e15, 1e15},
    {"cos of much", portable::cos, std::cos, -1e15, 1e15},
    {"sine", [](double x) { return portable::sinCos(x).sine; }, std::sin, -100.0, 100.0},
    {"cosine", [](double x) { return portable::sinCos(x).cosine; }, std::cos, -100.0, 100.0},
    {"asin", portable::asin, std::asin, -1.0, 1.0},
    {"atan", portable::atan, std::atan, -50.0, 50.0},
    {"exp", portable::exp, std::exp, -700.0, 700.0},
    {"exp2", portable::exp2, std::exp2, -1000.0, 1000.0},
    {"log", portable::log, std::log, -300.0, 300.0, true},
    {"log near 1", portable::log, std::log, 0.9, 1.1},
    {"log1p", portable::log1p, std::log1p, -15.0, 300.0, true},
    {"log2", portable::log2, std::log2, -300.0, 300.0, true},
    {"log10", portable::log10, std::log10, -300.0, 300.0, true},
    {"cbrt", portable::cbrt, std::cbrt, -1e9, 1e9},
    {"erf", portable::erf, std::erf, -6.0, 6.0},
    {"erfc", portable::erfc, std::erfc, -6.0, 26.0, false, 1.5},
};

/// The distance of a value to the exact one, in units of its last place.
double unitsOff(double value, long double exact) {
  const double size = std::abs(static_cast<double>(exact));
  return static_cast<double>(std::abs(value - exact)) / (std::nextafter(size, kInfinity) - size);
}

// beside the C library's functions of long double
TEST(PortableMath, IsExactButForTheLastPlace) {
  std::mt19937_64 random(1);
  for (const Function& f : kFunctions) {
    std::uniform_real_distribution<double> drawn(f.low, f.high);
    double worst = 0.0;
    for (int i = 0; i < 200000; ++i) {
      const double x = f.decades ? std::pow(10.0, drawn(random)) : drawn(random);
      worst = std::max(worst, unitsOff(f.portable(x), f.exact(x)));
    }
    EXPECT_LE(worst, f.units) << f.name;
  }
}

TEST(PortableMath, OfTwoArgumentsIsExactButForTheLastPlaces) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-50.0, 50.0), exponent(-20.0, 20.0);
  double angles = 0.0, powers = 0.0;
  for (int i = 0; i < 200000; ++i) {
    const double y = place(random), x = place(random), e = exponent(random);
    using Long = long double;
    angles = std::max(angles, unitsOff(portable::atan2(y, x), std::atan2(Long{y}, Long{x})));
    powers = std::max(powers, unitsOff(portable::pow(std::abs(x), e), std::pow(Long{std::abs(x)}, Long{e})));
  }
  EXPECT_LE(angles, 3.5);
  EXPECT_LE(powers, 1.0);
}

void expectSame(double value, double expected, const char* what) {
  if (std::isnan(expected)) {
    EXPECT_TRUE(std::isnan(value)) << what << ": " << value;
    return;
  }
  EXPECT_EQ(value, expected) << what;
  EXPECT_EQ(std::signbit(value), std::signbit(expected)) << what;
}

TEST(PortableMath, SpecialValuesAreThoseOfTheCLibrary) {
  for (const Function& f : kFunctions) {
    for (const double x : {0.0, -0.0, kInfinity, -kInfinity, kNaN})
      expectSame(f.portable(x), static_cast<double>(f.exact(x)), f.name);
  }
  for (const double a : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, kNaN}) {
    for (const double b : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity, kNaN}) {
      expectSame(portable::atan2(a, b), std::atan2(a, b), "atan2");
      expectSame(portable::pow(a, b), std::pow(a, b), "pow");
    }
  }
}

TEST(PortableMath, OutOfRange) {
  EXPECT_TRUE(std::isnan(portable::asin(1.5)));
  EXPECT_TRUE(std::isnan(portable::log(-1.0)));
  EXPECT_TRUE(std::isnan(portable::log1p(-2.0)));
  EXPECT_TRUE(std::isnan(portable::pow(-2.0, 0.5)));
  EXPECT_EQ(portable::exp(1000.0), kInfinity);
  EXPECT_EQ(portable::exp(-1000.0), 0.0);
  EXPECT_EQ(portable::pow(10.0, 400.0), kInfinity);
}

// of which files print six figures
TEST(PortableMath, PowersOfTenAndTwoAreExact) {
  for (int n = 0; n <= 22; ++n) {
    const double power = std::stod("1e" + std::to_string(n));
    EXPECT_EQ(portable::pow(10.0, n), power);
    EXPECT_EQ(portable::log10(power), n);
    EXPECT_EQ(portable::log10(std::stod("1e-" + std::to_string(n))), -n);
  }
  for (int n = -1000; n <= 1000; ++n) {
    EXPECT_EQ(portable::exp2(n), std::ldexp(1.0, n));
    EXPECT_EQ(portable::log2(std::ldexp(1.0, n)), n);
  }
}

TEST(PortableMath, Square) { EXPECT_EQ(square(-1.5), 2.25); }

}  // namespace tank_datum::portable_math_test
