// Commits files given on the command line, for tests of the commit alone:
//   results_probe PROGRAM DIR [NAME=CONTENT | tank_N/NAME=CONTENT]...
// Without files it puts DIR right as a reader does.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "results/result_folder.h"
#include "results/stop_signals.h"
#include "tank_datum/core/error.h"

int main(int argc, char** argv) {
  using namespace tank_datum;
  const std::string program = argv[1], folder = argv[2];
  results::stopCleanly(program);
  try {
    if (argc == 3) {
      settleToRead(folder, program);
      return 0;
    }
    ResultFolder results(folder, program);
    for (int i = 3; i < argc; ++i) {
      const std::string given = argv[i], path = given.substr(0, given.find('='));
      const std::filesystem::path place(path);
      std::ofstream out(results.stage(place.parent_path().string()) + "/" + place.filename().string());
      out << given.substr(path.size() + 1);
      out.close();
      if (!out) throw Error(Error::Kind::File, "probe", path, "not written", "a folder with room");
    }
    results.commit();
    return 0;
  } catch (const Error& error) {
    std::cerr << program << ": " << error.what() << "\n";
    return error.kind() == Error::Kind::Option ? 2 : 3;
  }
}
