#include "options/option_rows.h"
#include "options/option_table.h"

namespace tank_datum {

std::vector<Option> movementOptionsOf(MovementOptions& movement) {
  option_rows::Table t;
  t.topic = "Movement since an earlier survey";
  t.add("remove", "movement.remove",
        option_rows::choiceOf(movement.removal, {Removal::Auto, Removal::Nothing, Removal::Mean, Removal::Tilt}),
        "what is taken from the movement: nothing, the mean, mean and tilt; auto: nothing, but between levelling and "
        "scan the mean, since the rod does not stand where the scan's datum is");
  t.add("registration_error", "movement.registration_error", &movement.registration_error,
        "1 sigma of the height left between the surveys")
      .in(Unit::Metres)
      .within(within(0, 1000));
  t.add("registration_tilt_arcsec", "movement.registration_tilt_arcsec", &movement.registration_tilt,
        "1 sigma of the tilt left between them, about either level axis")
      .in(Unit::ArcSeconds)
      .within(within(0, 324'000));
  t.add("azimuth_offset_deg", "movement.azimuth_offset_deg", &movement.azimuth_offset,
        "turn of the later survey's frame, counter-clockwise")
      .in(Unit::Degrees)
      .within(within(-360, 360));
  t.add("estimate_azimuth_offset", "movement.estimate_azimuth_offset", &movement.estimate_offset,
        "find that turn by the datum's shape out of plane")
      .withNo();
  t.add("correlation_deg", "movement.correlation_deg", &movement.correlation,
        "arc within which stations share errors; 0: as the surveys say themselves")
      .in(Unit::Degrees)
      .within(within(0, 360));
  t.add("radius_difference", "movement.radius_difference", &movement.radius_difference,
        "surveys whose radii differ by more are of different tanks")
      .in(Unit::Metres)
      .within(above(0));
  t.add("centre_distance", "movement.centre_distance", &movement.centre_distance, "the same of their centres")
      .in(Unit::Metres)
      .within(above(0));
  return t.rows;
}

}  // namespace tank_datum
