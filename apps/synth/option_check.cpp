#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>

#include "option_fields.h"

namespace tank_datum::synth {
namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

constexpr double kFarthest = 1e8;  // of anything from a map's zero [m]

/// Collects the first value outside its limits.
class Checker {
 public:
  std::optional<Refusal> error;

  void number(const char* name, double value, Limit limit = {}) {
    if (error) return;
    const bool low_ok = limit.open ? value > limit.low : value >= limit.low;
    if (std::abs(value) <= kFarthest && low_ok && value <= limit.high) return;
    refuse(name, shown(value), expected(limit));
  }
  void angle(const char* name, double value, Limit limit = {}) {
    const double rounded = std::round(degrees(value) * 1e10) / 1e10;  // 360 deg may be 360.00000000000006 on return
    number(name, rounded, limit);
  }
  void arcsec(const char* name, double value, Limit limit = {}) { angle(name, 3600.0 * value, limit); }
  void integer(const char* name, int value, Limit limit = {}) { number(name, value, limit); }
  void unsignedInteger(const char*, std::uint64_t) {}
  void optional(const char* name, double value) {
    if (!std::isnan(value)) number(name, value);
  }
  void flag(const char*, bool) {}
  void triple(const char* name, const std::array<double, 3>& values) {
    for (const double value : values) number(name, value);
  }
  void choice(const char* name, const std::string& value, std::initializer_list<const char*> allowed) {
    std::string all;
    for (const char* one : allowed) {
      if (value == one) return;
      all += (all.empty() ? "" : ", ") + std::string(one);
    }
    if (!error) refuse(name, value, "one of " + all);
  }
  template <class T>
  void group(const std::string& name, T& options) {
    const std::string outer = path_;
    path_ += name + ".";
    fields(*this, options);
    path_ = outer;
  }
  template <class T>
  void list(const std::string& name, std::vector<T>& options) {
    for (std::size_t i = 0; i < options.size(); ++i) group(name + "[" + std::to_string(i) + "]", options[i]);
  }
  void refuse(const std::string& name, const std::string& value, const std::string& must) {
    error = Refusal{path_ + name, value, must};
  }

 private:
  static std::string expected(const Limit& limit) {
    const double high = std::min(limit.high, kFarthest);
    if (std::isinf(limit.low)) return shown(-high) + " .. " + shown(high);
    if (limit.open) return "> " + shown(limit.low) + " and <= " + shown(high);
    return shown(limit.low) + " .. " + shown(high);
  }

  std::string path_;
};

/// A heap that reaches past the foundation's edge would hang in the air.
void checkSoil(Checker& check, const std::string& name, const TankOptions& tank) {
  const Foundation& f = tank.foundation;
  const double edge = f.kind == "pad" ? f.pad_width : f.kind == "crown" ? f.slab_width : f.ringwall_width;
  for (std::size_t i = 0; i < tank.soil.size() && !check.error; ++i)
    if (tank.soil[i].reach > edge)
      check.refuse(name + "soil[" + std::to_string(i) + "].reach", shown(tank.soil[i].reach), "within the foundation");
}

/// What two values of a tank say about each other.
void checkTank(Checker& check, const std::string& name, const TankOptions& tank) {
  const Foundation& f = tank.foundation;
  const double courses = std::floor(tank.height / tank.course_height);
  if (tank.tilt_slope != 0.0 && tank.tilt_total != 0.0)
    check.refuse(name + "tilt_total", shown(tank.tilt_total), "0 when tilt_slope is given");
  else if (std::abs(tank.tilt_total) > 0.2 * tank.radius)
    check.refuse(name + "tilt_total", shown(tank.tilt_total), "at most a tenth of the diameter");
  else if (tank.lobes.max_length < tank.lobes.min_length)
    check.refuse(name + "lobes.max_length", shown(tank.lobes.max_length), ">= lobes.min_length");
  else if (tank.lobes.amplitude > 0.0 && tank.lobes.min_length < 2.0 * kPi * tank.radius / 200.0)
    check.refuse(name + "lobes.min_length", shown(tank.lobes.min_length), "at least a 200th of the circumference");
  else if (tank.course_step * courses >= tank.thickness)
    check.refuse(name + "course_step", shown(tank.course_step), "less than thickness / number of courses");
  else if (f.kind == "annular_plate" && f.ringwall_width <= f.plate_width + f.plate_width_variation)
    check.refuse(name + "foundation.ringwall_width", shown(f.ringwall_width), "> plate_width + plate_width_variation");
  else if (f.plate_width - f.plate_width_variation <= f.weld)
    check.refuse(name + "foundation.plate_width", shown(f.plate_width), "> weld + plate_width_variation");
  else if (f.kind == "crown" && f.crown_inner <= f.plate_width + f.plate_width_variation)
    check.refuse(name + "foundation.crown_inner", shown(f.crown_inner), "> plate_width + plate_width_variation");
  else if (f.kind == "crown" && f.crown_outer <= f.crown_inner)
    check.refuse(name + "foundation.crown_outer", shown(f.crown_outer), "> crown_inner");
  else if (f.kind == "crown" && f.slab_width <= f.crown_outer)
    check.refuse(name + "foundation.slab_width", shown(f.slab_width), "> crown_outer");
  else if (f.kind == "pad" && f.pad_width <= f.weld)
    check.refuse(name + "foundation.pad_width", shown(f.pad_width), "> weld");
  else if (f.kind == "pad" && f.concentric)
    check.refuse(name + "foundation.concentric", "true", "false for a pad, which has no kerb");
  else if (f.kind == "pad" && !f.sectors.empty())
    check.refuse(name + "foundation.sectors", "given", "none for a pad, which the shell stands on");
  if (!check.error) checkSoil(check, name, tank);
}

void checkScene(Checker& check, const SceneOptions& scene) {
  const int tanks = static_cast<int>(scene.tanks.size());
  if (tanks == 0) check.refuse("tanks", "[]", "at least one");
  for (std::size_t i = 0; i < scene.tanks.size() && !check.error; ++i)
    checkTank(check, "tanks[" + std::to_string(i) + "].", scene.tanks[i]);
  for (std::size_t i = 0; i < scene.objects.size() && !check.error; ++i)
    if (scene.objects[i].tank >= tanks)
      check.refuse("objects[" + std::to_string(i) + "].tank", std::to_string(scene.objects[i].tank),
                   "the index of a tank");
  if (check.error) return;
  const ScannerOptions& s = scene.scanner;
  if (s.tank >= tanks)
    check.refuse("scanner.tank", std::to_string(s.tank), "the index of a tank");
  else if (s.max_elevation <= s.min_elevation)
    check.refuse("scanner.max_elevation_deg", shown(degrees(s.max_elevation)), "> min_elevation_deg");
  else if (s.inside && s.stations.empty() && s.distance >= 0.9 * scene.tanks[static_cast<std::size_t>(s.tank)].radius)
    check.refuse("scanner.distance", shown(s.distance), "< 0.9 radius for a scanner inside");
  else if (!s.inside && s.stations.empty() && s.distance < 0.5)
    check.refuse("scanner.distance", shown(s.distance), ">= 0.5 for a scanner outside");
  for (std::size_t i = 0; i < s.registration.errors.size() && !check.error; ++i) {
    const int count = s.stations.empty() ? s.count : static_cast<int>(s.stations.size());
    if (s.registration.errors[i].scanner >= count)
      check.refuse("scanner.registration.errors[" + std::to_string(i) + "].scanner",
                   std::to_string(s.registration.errors[i].scanner), "the index of a scanner");
  }
  if (check.error) return;
  if (scene.clutter.max_gap < scene.clutter.min_gap)
    check.refuse("clutter.max_gap", shown(scene.clutter.max_gap), ">= min_gap");
}

}  // namespace

std::optional<Refusal> firstError(const SceneOptions& options) {
  SceneOptions copy = options;  // visitors take what they visit by reference
  Checker check;
  fields(check, copy);
  if (!check.error) checkScene(check, copy);
  return check.error;
}

}  // namespace tank_datum::synth
