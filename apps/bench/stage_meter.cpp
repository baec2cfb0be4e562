#include "stage_meter.h"

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace tank_datum::bench {
namespace {

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// proc(5): 5 written to clear_refs sets the peak resident size to the present one.
void restartPeak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

std::uint64_t peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

void StageMeter::begin(const std::string& name) {
  end();
  stages_.push_back({name, 0.0, 0.0, 0});
  restartPeak();
  running_ = true;
  cpu_since_ = cpuSeconds();
  since_ = Clock::now();
}

void StageMeter::end() {
  if (!running_) return;
  running_ = false;
  StageCost& stage = stages_.back();
  stage.seconds = std::chrono::duration<double>(Clock::now() - since_).count();
  stage.cpu_seconds = cpuSeconds() - cpu_since_;
  stage.peak_memory = peakMemory();
}

StageCost totalOf(const std::vector<StageCost>& stages) {
  StageCost total{"total", 0.0, 0.0, 0};
  for (const StageCost& stage : stages) {
    total.seconds += stage.seconds;
    total.cpu_seconds += stage.cpu_seconds;
    total.peak_memory = std::max(total.peak_memory, stage.peak_memory);
  }
  return total;
}

}  // namespace tank_datum::bench
