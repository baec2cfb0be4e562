#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tank_datum {

/// Seconds of each stage, and the stage's name on the terminal while it runs.
class StageClock {
 public:
  /// @param show  print progress to stderr; only done when stderr is a terminal
  explicit StageClock(bool show);
  ~StageClock();

  /// Ends the running stage and begins the next one.
  void begin(const std::string& stage);
  /// Shows how far the running stage is, at which rate, and the time left.
  void progress(std::uint64_t done, std::uint64_t of);
  /// Ends the running stage and clears the progress line.
  void end();

  /// {"stages": {name: seconds, ...}, "total": seconds, "peak_memory_bytes": ...}
  std::string json() const;

 private:
  using Clock = std::chrono::steady_clock;
  bool show_;
  std::string running_;
  Clock::time_point since_, shown_, start_ = Clock::now();
  std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace tank_datum
