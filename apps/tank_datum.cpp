#include "datum_command.h"

int main(int argc, char** argv) { return tank_datum::datumCommand(argc, argv); }
