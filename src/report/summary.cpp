#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/statistics.h"
#include "core/units.h"
#include "refusals.h"
#include "report/shell_report.h"
#include "report/sparkline.h"
#include "setups/setup_report.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/report/report.h"
#include "tank_datum/shape/analysis.h"
#include "tank_datum/stations/stations.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSparklineColumns = 48;  ///< three bytes each, within the buffer of a line

template <typename... Values>
std::string line(const char* title, const char* format, Values... values) {
  char titled[20], text[240];
  std::snprintf(titled, sizeof titled, "%-14s ", title);
  if constexpr (sizeof...(values) == 0) {
    std::snprintf(text, sizeof text, "%s", format);
  } else {
    std::snprintf(text, sizeof text, format, values...);
  }
  return std::string(titled) + text + "\n";
}

double medianSigma(const std::vector<Station>& stations) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) sigmas.push_back(s.sigma_z);
  }
  return median(std::move(sigmas));
}

std::string tankLine(const Datum& datum) {
  if (datum.levelled) return line("tank", "radius %.3f m as given", datum.circle.radius);
  return line("tank", "radius %.3f m, centre %.3f, %.3f, shell seen over %.0f deg", datum.circle.radius,
              datum.circle.center.x() + datum.origin.x(), datum.circle.center.y() + datum.origin.y(),
              toDegrees(datum.tank.coverage));
}

std::string stationsLine(const Datum& datum) {
  const Level& level = datum.level;
  char density[48] = "";
  if (std::isfinite(datum.foot_density)) {
    std::snprintf(density, sizeof density, "; %.*f foundation points a degree", datum.foot_density < 9.95 ? 1 : 0,
                  datum.foot_density);
  }
  return line("stations", "%zu measured, %zu interpolated, %zu missing%s", level.measured, level.interpolated,
              level.missing, density);
}

std::string methodLines(const Datum& datum) {
  if (datum.levelled) return line("method", "elevations typed in from a levelling survey");
  const std::string curve =
      line("paper's curve", "RMS %.1f mm, largest %.1f mm over %zu points not used in the fit (%td control points)",
           1e3 * datum.curve.rms, 1e3 * datum.curve.max_residual, datum.curve.check_points,
           datum.curve.control_points.rows());
  if (!datum.refined.valid()) {
    return line("method", "the paper's curve through edge points: expect millimetres of bias") + curve;
  }
  return line("method", "shell and %s intersected, standard error %.2f mm (median)",
              nameOf(datum.refined.profile.surface), 1e3 * medianSigma(datum.stations)) +
         curve;
}

/// The plane and what departs from it.
std::string tiltLine(const Datum& datum) {
  if (!datum.tilt.valid()) return {};
  char bending[80] = "";
  const OutOfPlane& rest = datum.analysis.out_of_plane;
  if (std::isfinite(rest.max_u)) {
    std::snprintf(bending, sizeof bending, "; out of plane at most %.1f mm at %.0f deg", 1e3 * rest.max_u,
                  toDegrees(rest.max_u_azimuth));
  }
  return line("tilt", "%.1f arc-seconds towards %.0f deg%s", toArcSeconds(std::atan(datum.tilt.slope())),
              toDegrees(datum.tilt.direction), bending);
}

/// Settlements and rises of single places, the largest first.
std::string localLine(std::vector<LocalSettlement> all) {
  constexpr std::size_t kShown = 3;
  constexpr double kPrinted = 5e-5;  // what is not 0.0 mm
  const auto nil = [](const LocalSettlement& s) { return std::abs(s.height) < kPrinted; };
  all.erase(std::remove_if(all.begin(), all.end(), nil), all.end());
  if (all.empty()) return {};
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return std::abs(a.height) > std::abs(b.height); });
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, all.size()); ++i) {
    char part[100];
    std::snprintf(part, sizeof part, "%s%+.1f +- %.1f mm (2 sigma) at %.0f deg, %.0f deg wide", i > 0 ? "; " : "",
                  1e3 * all[i].height, 2e3 * all[i].sigma, toDegrees(all[i].azimuth), toDegrees(all[i].width));
    text += part;
  }
  if (all.size() > kShown) text += "; " + std::to_string(all.size() - kShown) + " more";
  return line("local", "%s", text.c_str());
}

std::string antipodalLine(const Antipodal& across) {
  if (!std::isfinite(across.max_h)) return {};
  return line("antipodal", "h %.1f mm over D %.3f m: %.5f deg, %.1f arc-seconds, azimuth %.0f deg", 1e3 * across.max_h,
              across.diameter, toDegrees(across.angle()), toArcSeconds(across.angle()), toDegrees(across.azimuth));
}

/// A value with its limit as people say it: lengths in millimetres.
std::string figures(const Check& check) {
  char text[80];
  if (check.unit == "m") {
    std::snprintf(text, sizeof text, "%.1f mm, limit %.1f mm", 1e3 * check.value, 1e3 * check.limit);
  } else {
    std::snprintf(text, sizeof text, "%.2g, limit %.2g %s", check.value, check.limit, check.unit.c_str());
  }
  return text;
}

/// How many checks ended how, then those that failed, the furthest beyond its limit first; without any, the undecided
/// one nearest to it.
std::string checkLines(const std::vector<Check>& checks) {
  if (checks.empty()) return {};
  int counts[5] = {};
  std::vector<const Check*> failed, undecided;
  for (const Check& c : checks) {
    ++counts[static_cast<int>(c.verdict)];
    if (c.verdict == Verdict::Fail && c.role != "second opinion") failed.push_back(&c);
    if (c.verdict == Verdict::Undecided && c.role != "second opinion") undecided.push_back(&c);
  }
  const auto graver = [](const Check* a, const Check* b) { return a->value / a->limit > b->value / b->limit; };
  std::stable_sort(failed.begin(), failed.end(), graver);
  std::stable_sort(undecided.begin(), undecided.end(), graver);
  if (undecided.size() > 1) undecided.resize(1);
  std::string lines = line(
      "checks", "%d pass, %d fail, %d undecided, %d not evaluated, %d not applicable (screening, no code evaluation)",
      counts[0], counts[1], counts[2], counts[4], counts[3]);
  for (const Check* c : failed.empty() ? undecided : failed) {
    lines += line(nameOf(c->verdict), "%s %s: %s", c->code.c_str(), c->name.c_str(), figures(*c).c_str());
  }
  return lines;
}

std::string verdictLine(const Analysis& analysis) {
  if (!analysis.valid()) return {};
  const Headline& h = analysis.headline;
  if (!std::isfinite(h.utilisation)) return line("verdict", "%s: %s", h.word.c_str(), h.governing.c_str());
  return line("verdict", "%s: %s, %.0f %% of its limit", h.word.c_str(), h.governing.c_str(), 100.0 * h.utilisation);
}

}  // namespace

std::string summary(const Datum& datum, bool blocks) {
  std::string text = line("status", "%s", nameOf(datum.status));
  if (!datum.message.empty()) text += "               " + datum.message + "\n";
  if (!datum.hasStations()) return text;
  const Level& level = datum.level;
  const double z = datum.origin.z();
  text += tankLine(datum);
  text += stationsLine(datum);
  const std::string setups = datum.levelled ? "" : setupSummary(datum.agreement, datum.stations);
  if (!setups.empty() && setups != "1") text += line("setups", "%s", setups.c_str());
  text += line("datum", "mean %.4f m, range %.1f mm: lowest %.4f m at %.0f deg, highest %.4f m at %.0f deg",
               level.mean + z, 1e3 * level.range(), level.min + z, toDegrees(level.min_azimuth), level.max + z,
               toDegrees(level.max_azimuth));
  if (blocks) {
    text += line("elevation", "%s from station 0 round", sparkline(datum.stations, kSparklineColumns).c_str());
  }
  const std::string lean = leanText(datum, {});
  if (!lean.empty()) text += line("lean", "%s", lean.c_str());
  return text + methodLines(datum) + tiltLine(datum) + localLine(datum.analysis.local_settlements) +
         antipodalLine(datum.antipodal) + shellSummary(datum.shell, datum.analysis.roundness) +
         checkLines(datum.analysis.checks) + verdictLine(datum.analysis);
}

}  // namespace tank_datum
