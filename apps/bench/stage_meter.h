#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace tank_datum::bench {

/// What a stage cost.
struct StageCost {
  std::string name;
  double seconds = 0.0;           ///< by the clock on the wall
  double cpu_seconds = 0.0;       ///< of all threads; what other programs take from the machine bears less on it
  std::uint64_t peak_memory = 0;  ///< of the process during the stage [bytes]
};

/// Measures stages one after the other. Linux: the kernel is told to begin the peak anew with each.
class StageMeter {
 public:
  ~StageMeter() { end(); }

  /// Ends the running stage and begins the next one.
  void begin(const std::string& name);
  void end();

  const std::vector<StageCost>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool running_ = false;
  Clock::time_point since_;
  double cpu_since_ = 0.0;
  std::vector<StageCost> stages_;
};

/// Seconds summed, the largest peak.
StageCost totalOf(const std::vector<StageCost>& stages);

}  // namespace tank_datum::bench
