#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace tank_datum::rates {

/// Simulated surveys of one made tank: R 30 m, H 16 m, 235 MPa, 206 GPa, in service.
struct ShapeTrial {
  int runs = 400;
  int stations = 360;
  double sigma = 0.001;        ///< actual errors of a station [m]
  double claimed = 1.0;        ///< what the survey says of them, over that; 0: it says nothing
  double correlated_deg = 0;   ///< errors are means of white noise over so much; 0: white
  double gap_deg = 0;          ///< of the ring is not seen
  std::string waves = "fall";  ///< fall: 8 mm (2/n)^2 for n = 2 to 15; few: n = 2, 3, 9 alone; one: a single wave
  int wave = 3;                ///< number of the single wave
  double of_limit = 0.0;  ///< the waves are scaled so that the judged figure is so much of its limit; 0: as they are
  std::string figure = "curvature";  ///< the figure that is scaled and whose verdicts are counted
};

struct ShapeRates {
  int runs = 0;
  int tilt = 0, curvature = 0, u = 0, s = 0, level = 0;  ///< 95 % intervals that hold the truth
  long waves = 0, all_waves = 0;                         ///< amplitudes of n = 2 to 6 within their intervals
  int passed = 0, failed = 0, undecided = 0;             ///< verdicts on the figure
  int wrong_fails = 0;  ///< surveys of which any judged rule fails that the truth does not
};

/// Declares the command `shape` and its options; `trial` must outlive the parsing.
CLI::App* addShape(CLI::App& app, ShapeTrial& trial);

ShapeRates ratesOf(const ShapeTrial& trial);

/// One line on stdout.
void print(const ShapeTrial& trial, const ShapeRates& rates);

}  // namespace tank_datum::rates
