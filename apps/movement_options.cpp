#include "movement_options.h"

#include <map>

#include "core/units.h"

namespace tank_datum {
namespace {

constexpr double kArcSecond = kDegree / 3600.0;

const std::map<std::string, Removal> kRemovals = {
    {"none", Removal::Nothing}, {"mean", Removal::Mean}, {"tilt", Removal::Tilt}};

}  // namespace

TypedMovement::TypedMovement(const MovementOptions& options)
    : removal(nameOf(options.removal)),
      tilt_arcsec(options.registration_tilt / kArcSecond),
      offset_deg(options.azimuth_offset / kDegree),
      correlation_deg(options.correlation / kDegree) {}

void TypedMovement::putInto(MovementOptions& options) const {
  options.removal = kRemovals.at(removal);
  options.registration_tilt = tilt_arcsec * kArcSecond;
  options.azimuth_offset = offset_deg * kDegree;
  options.correlation = correlation_deg * kDegree;
}

void addMovementOptions(CLI::App& app, MovementOptions& options, TypedMovement& typed) {
  app.add_option(
         "--remove", typed.removal,
         "what is taken from the movement: nothing, the mean, mean and tilt; between levelling and scan the mean, "
         "since the rod does not stand where the scan's datum is")
      ->check(CLI::IsMember(kRemovals));
  app.add_option("--registration-error", options.registration_error,
                 "1 sigma of the height left between the surveys [m]");
  app.add_option("--registration-tilt-arcsec", typed.tilt_arcsec,
                 "1 sigma of the tilt left between them, about either level axis");
  app.add_option("--azimuth-offset-deg", typed.offset_deg, "turn of the later survey's frame, counter-clockwise");
  app.add_flag("--estimate-azimuth-offset,!--no-estimate-azimuth-offset", options.estimate_offset,
               "find that turn by the datum's shape");
  app.add_option("--correlation-deg", typed.correlation_deg,
                 "arc within which stations share errors; 0: as the surveys say themselves");
  app.add_option("--radius-difference", options.radius_difference,
                 "surveys whose radii differ by more are of different tanks [m]");
  app.add_option("--centre-distance", options.centre_distance, "the same of their centres [m]");
}

}  // namespace tank_datum
