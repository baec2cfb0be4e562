#pragma once

#include <string>

#include "options.h"

namespace tank_datum::synth {

struct Command {
  std::string output;  ///< PCD
  std::string truth;   ///< JSON
  bool ascii = false;
  bool doubles = false;       ///< coordinates of 8 bytes instead of 4
  bool split = false;         ///< one PCD per scanner: OUT_1.pcd, OUT_2.pcd ..., each with its VIEWPOINT
  bool label_setups = false;  ///< a field `setup`: the scanner's number, from 1
  bool quiet = false;
  unsigned threads = 0;  ///< 0 = as many as the machine has
  SceneOptions scene;
};

/// Reads the command line; the scene is the scene file's with the options given put over it.
/// @return false when the program shall end with `status` (help asked for, wrong use); what to say has been said
/// @throws Error for a scene file or a value in it
bool parseCommandLine(int argc, char** argv, Command& command, int& status);

}  // namespace tank_datum::synth
