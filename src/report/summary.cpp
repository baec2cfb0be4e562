#include <algorithm>
#include <cmath>

#include "core/azimuth.h"
#include "core/plain_text.h"
#include "core/portable_math.h"
#include "core/statistics.h"
#include "core/units.h"
#include "limits/checks.h"
#include "refusals.h"
#include "report/check_text.h"
#include "report/display.h"
#include "report/movement_text.h"
#include "report/shell_report.h"
#include "report/sparkline.h"
#include "report/station_arcs.h"
#include "report/summary_line.h"
#include "report/verdict_lines.h"
#include "setups/setup_report.h"
#include "tank_datum/limits/limits.h"
#include "tank_datum/report/report.h"
#include "tank_datum/shape/analysis.h"
#include "tank_datum/stations/stations.h"
#include "trust/foot_density.h"

namespace tank_datum {
namespace {

constexpr std::size_t kSparklineColumns = 48;

double medianSigma(const std::vector<Station>& stations) {
  std::vector<double> sigmas;
  for (const Station& s : stations) {
    if (s.flag == StationFlag::Measured) sigmas.push_back(s.sigma_z);
  }
  return median(std::move(sigmas));
}

std::string tankLine(const Datum& datum, const Display& display) {
  const std::string radius = display.longText(datum.circle.radius);
  if (datum.levelled) return line("tank", "radius %s as given", radius.c_str());
  return line("tank", "radius %s, centre %s, %s, shell seen over %.0f deg", radius.c_str(),
              display.longFigure(datum.circle.center.x() + datum.origin.x()).c_str(),
              display.longFigure(datum.circle.center.y() + datum.origin.y()).c_str(), toDegrees(datum.tank.coverage));
}

/// What the shell stands upon, where that stands out of the ground and of the shell. Cladding of a lowest part looks
/// the same, so that a reader has to know.
std::string ringwallLine(const Datum& datum, const Display& display) {
  if (!datum.tank.standsOnRingwall()) return {};
  return line("ringwall", "the shell begins %s above the ground, upon what stands out by %s",
              display.longText(datum.tank.ringwall_height, 1).c_str(),
              display.longText(datum.tank.ringwall_width, 2).c_str());
}

/// How the azimuths below are counted, where it is not counter-clockwise from +x.
std::string azimuthsLine(const StationOptions& options) {
  if (!options.clockwise && options.zero_azimuth == 0.0) return {};
  return line("azimuths", "%s from %s deg counter-clockwise of +x",
              options.clockwise ? "clockwise" : "counter-clockwise",
              fixedText(toDegrees(options.zero_azimuth), 1).c_str());
}

/// The rows that hold nothing to measure, where there are any.
std::string passedOverLine(const ScanCounts& counts) {
  std::string text;
  const auto add = [&text](std::uint64_t rows, const char* what) {
    if (rows > 0) text += (text.empty() ? "" : ", ") + std::to_string(rows) + " " + what;
  };
  add(counts.invalid, "without coordinates");
  add(counts.left_out, "withheld or not asked for");
  add(counts.far, "far from the tank or at zero of the scan's frame");
  if (text.empty()) return {};
  return line("passed over", "%s of %s rows", text.c_str(), std::to_string(counts.points).c_str());
}

std::string stationsLine(const Datum& datum) {
  const Level& level = datum.level;
  const std::string density = std::isfinite(datum.foot_density) ? "; " + footDensityText(datum.foot_density) : "";
  return line("stations", "%zu measured, %zu interpolated, %zu missing%s", level.measured, level.interpolated,
              level.missing, density.c_str());
}

/// Where too little of the foundation or of the shell is seen; where soil or a kerb, or inside of it liquid or a coil,
/// lies at the shell, or a sector of the foundation stands off the rest; where it is not the shell that stands there;
/// where the datum is known to lie lower than the stations beside a gap say; and where what was refused may be the
/// datum.
std::string unmeasuredLines(const Datum& datum) {
  constexpr double kNamed = 3.0 / 360.0;  // of a turn; of shorter arcs there are many beside a foot
  const auto named = static_cast<std::size_t>(std::max(1.0, kNamed * static_cast<double>(datum.stations.size())));
  const bool inside = datum.tank.side == Side::Inside;
  std::string surface = inside ? "floor" : nameOf(datum.refined.profile.surface);
  std::replace(surface.begin(), surface.end(), '_', ' ');
  std::string text;
  const auto add = [&](const char* title, const std::vector<char>& is, std::size_t shortest, const std::string& what) {
    const std::string arcs = arcsText(is, datum.stations, shortest);
    if (!arcs.empty()) text += line(title, "at %s %s", arcs.c_str(), what.c_str());
  };
  if (datum.refined.valid()) {
    add("hidden", withReason(datum.stations, Unmeasured::Hidden), named,
        "too few points of the " + surface + " are seen beside the shell: not measured");
    add("no shell", withReason(datum.stations, Unmeasured::NoShell), named, "the shell is not seen: not measured");
    add("other surface", withReason(datum.stations, Unmeasured::OtherSurface), named,
        "something else than the " + surface + " meets the shell, " + (inside ? "liquid or a coil" : "soil or a kerb") +
            ": not measured");
  }
  add("another wall", withReason(datum.stations, Unmeasured::OffCircle), named,
      "what stands there is not the shell, cladding or a pipe: not measured, no part of its shape");
  add("shell below", withReason(datum.stations, Unmeasured::ShellBelow), 1,
      "the shell is seen below the level of the stations beside: the datum lies lower there");
  add("in doubt", maybeHeaved(datum.stations), 1,
      "what was refused may be a heave of the foundation: intervals of the checks hold it");
  return text;
}

std::string methodLines(const Datum& datum, const Display& display) {
  if (datum.levelled) return line("method", "elevations typed in from a levelling survey");
  const std::string curve =
      !datum.curve.valid()
          ? ""
          : line("paper's curve", "RMS %s, largest %s over %zu points not used in the fit (%td control points)",
                 display.shortText(datum.curve.rms).c_str(), display.shortText(datum.curve.max_residual).c_str(),
                 datum.curve.check_points, datum.curve.control_points.rows());
  if (!datum.refined.valid()) {
    return line("method", "the paper's curve through edge points: expect millimetres of bias") + curve;
  }
  return line("method", "shell and %s intersected, standard error %s (median)", nameOf(datum.refined.profile.surface),
              display.shortText(medianSigma(datum.stations), 2).c_str()) +
         curve;
}

/// The largest departure from the plane, down negative.
std::string outOfPlaneText(const Datum& datum, const Display& display) {
  const OutOfPlane& rest = datum.analysis.out_of_plane;
  if (!std::isfinite(rest.max_u)) return {};
  const auto apart = [&](const Station& s) {
    return std::isfinite(s.u) ? std::abs(std::remainder(s.azimuth - rest.max_u_azimuth, kTwoPi)) : kTwoPi;
  };
  const auto place = std::min_element(datum.stations.begin(), datum.stations.end(),
                                      [&](const Station& a, const Station& b) { return apart(a) < apart(b); });
  const bool is_down = place != datum.stations.end() && place->u < 0.0;
  return "; out of plane at most " + display.signedShort(is_down ? -rest.max_u : rest.max_u) + " " +
         display.shortUnit() + " at " + fixedText(wholeDegrees(rest.max_u_azimuth), 0) + " deg";
}

/// Towards where, of a tilt that stands out of its errors.
std::string sidesText(const Tilt& tilt) {
  constexpr double kShown = 0.05 / 3600.0 * kDegree;  // of less, which is 0.0 arc-seconds, a side says nothing
  if (tilt.slope() < kShown || tilt.slope() < 2.0 * tilt.sigma_slope) return ", not significant";
  const double high = wholeDegrees(tilt.direction);
  return formatted(", high side at %.0f deg, low side at %.0f deg", high, std::fmod(high + 180.0, 360.0));
}

/// The plane and what departs from it.
std::string tiltLine(const Datum& datum, const Display& display) {
  if (!datum.tilt.valid()) return {};
  const auto seconds = [](double slope) { return fixedText(toArcSeconds(portable::atan(slope)), 1); };
  const double sigma = datum.tilt.sigma_slope;
  const std::string error = std::isfinite(sigma) ? " +- " + seconds(2.0 * sigma) + " (2 sigma)" : "";
  return line("tilt", "%s arc-seconds%s%s%s", seconds(datum.tilt.slope()).c_str(), error.c_str(),
              sidesText(datum.tilt).c_str(), outOfPlaneText(datum, display).c_str());
}

/// Settlements and rises of single places, the largest first.
std::string localLine(std::vector<LocalSettlement> all, const Display& display) {
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
    snprintfPlain(part, sizeof part, "%s%s +- %s (2 sigma) at %.0f deg, %.0f deg wide", i > 0 ? "; " : "",
                  display.signedShort(all[i].height).c_str(), display.shortText(2.0 * all[i].sigma).c_str(),
                  wholeDegrees(all[i].azimuth), toDegrees(all[i].width));
    text += part;
  }
  if (all.size() > kShown) text += "; " + std::to_string(all.size() - kShown) + " more";
  return line("local", "%s", text.c_str());
}

std::string antipodalLine(const Antipodal& across, const Display& display) {
  if (!std::isfinite(across.max_h)) return {};
  return line("antipodal", "h %s over D %s: %.5f deg, %.1f arc-seconds, high end at %.0f deg",
              display.shortText(across.max_h).c_str(), display.longText(across.diameter).c_str(),
              toDegrees(across.angle()), toArcSeconds(across.angle()), wholeDegrees(across.azimuth));
}

std::string movementLine(const Provenance& provenance, const Display& display) {
  if (!provenance.movement || !provenance.movement->valid()) return {};
  const std::string& language = provenance.identity.language;
  const std::string moved = line("movement", "%s", movementText(*provenance.movement, display, language).c_str());
  return moved + line("limits", "%s", limitRatesText(provenance.limit_rates, display, language).c_str());
}

}  // namespace

std::string summary(const Datum& datum) {
  const Provenance nothing_said;
  return summary(datum, nothing_said);
}

std::string summary(const Datum& datum, const Provenance& provenance, bool blocks) {
  const Display display(provenance.identity.display_units);
  std::string text = line("status", "%s", nameOf(datum.status));
  if (!datum.message.empty()) text += "               " + datum.message + "\n";
  for (const std::string& advice : datum.sighting.advice) text += line("try", "%s", advice.c_str());
  if (!datum.hasStations()) return text;
  const Level& level = datum.level;
  const double z = datum.origin.z();
  text += tankLine(datum, display) + ringwallLine(datum, display);
  text += azimuthsLine(provenance.options.stations) + passedOverLine(datum.counts) + stationsLine(datum) +
          unmeasuredLines(datum);
  const auto length = [&](double metres) { return display.shortText(metres); };
  const std::string setups = datum.levelled ? "" : setupSummary(datum.agreement, datum.stations, length);
  if (!setups.empty() && setups != "1") text += line("setups", "%s", setups.c_str());
  text += line("datum", "mean %s, range %s: lowest %s at %.0f deg, highest %s at %.0f deg",
               display.longText(level.mean + z, 4).c_str(), display.shortText(level.range()).c_str(),
               display.longText(level.min + z, 4).c_str(), wholeDegrees(level.min_azimuth),
               display.longText(level.max + z, 4).c_str(), wholeDegrees(level.max_azimuth));
  if (blocks) {
    text += line("elevation", "%s from station 0 round", sparkline(datum.stations, kSparklineColumns).c_str());
  }
  const std::string lean = leanText(datum, provenance.options.stations);
  if (!lean.empty()) text += line("lean", "%s", lean.c_str());
  return text + methodLines(datum, display) + tiltLine(datum, display) +
         localLine(datum.analysis.local_settlements, display) + antipodalLine(datum.antipodal, display) +
         shellSummary(datum.shell, datum.analysis.roundness, display) + checkLines(datum.analysis.checks, display) +
         movementLine(provenance, display) + verdictLine(datum.analysis);
}

}  // namespace tank_datum
