#include "convert_command.h"

int main(int argc, char** argv) { return tank_datum::convertCommand(argc, argv); }
