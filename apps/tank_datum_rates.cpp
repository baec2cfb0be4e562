#include "parsed.h"
#include "rates/movement_rates.h"
#include "rates/shape_rates.h"
#include "run_main.h"
#include "tank_datum/version.h"

/// One command per question; each has its trial, its rates and its table in apps/rates/.
int main(int argc, char** argv) {
  using namespace tank_datum;
  return runMain("tank_datum_rates", [&]() -> int {
    CLI::App app("How often the statistics of tank_datum are right, on simulated surveys.", "tank_datum_rates");
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string("tank_datum_rates ") + kVersion);
    rates::MovementTrial movement;
    rates::addMovement(app, movement)->callback([&] { print(movement, rates::ratesOf(movement)); });
    rates::ShapeTrial shape;
    rates::addShape(app, shape)->callback([&] { print(shape, rates::ratesOf(shape)); });
    int status = kUsable;
    parsed(app, argc, argv, status);
    return status;
  });
}
