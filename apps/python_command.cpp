#include <pybind11/pybind11.h>

#include <chrono>
#include <csignal>
#include <future>
#include <thread>

#include "convert_command.h"
#include "python/command.h"
#include "python/foreign.h"
#include "results/manifest.h"
#include "results/stop_signals.h"

namespace py = pybind11;

namespace tank_datum::python {

int runCommand(std::vector<std::string> words) {
  const auto command = words.front() == results::kDatumProgram ? datumCommand : convertCommand;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const OpenForeign foreign = foreignReader(std::make_shared<PythonGate>());
  auto status = std::async(std::launch::async,
                           [&] { return command(static_cast<int>(words.size()), arguments.data(), foreign); });
  for (bool ended = false; !ended;) {
    {
      const py::gil_scoped_release unlocked;
      ended = status.wait_for(std::chrono::milliseconds(100)) == std::future_status::ready;
    }
    if (!ended && PyErr_CheckSignals() != 0) stopCommandBy(SIGINT, words.front());  // a handler has raised
  }
  return status.get();
}

void stopCommandBy(int signal_number, const std::string& program) {
  const py::gil_scoped_release unlocked;
  results::stopBy(signal_number, program);
}

}  // namespace tank_datum::python
