#include "stage_clock.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace tank_datum {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

StageClock::StageClock(bool show) : show_(show && isatty(STDERR_FILENO) != 0) {}

StageClock::~StageClock() { end(); }

void StageClock::begin(const std::string& stage) {
  end();
  running_ = stage;
  since_ = Clock::now();
  if (show_) std::fprintf(stderr, "\r\033[K%6.1f s  %s ...", secondsSince(start_), stage.c_str());
}

void StageClock::progress(std::uint64_t done, std::uint64_t of) {
  constexpr std::chrono::milliseconds kReadable(100);
  if (!show_ || running_.empty() || done == 0 || (done < of && Clock::now() - shown_ < kReadable)) return;
  shown_ = Clock::now();
  const double seconds = secondsSince(since_), rows = static_cast<double>(done), all = static_cast<double>(of);
  std::fprintf(stderr, "\r\033[K%6.1f s  %s %.0f %%  %.1f M points/s  %.0f s left", secondsSince(start_),
               running_.c_str(), 100.0 * rows / all, 1e-6 * rows / seconds, seconds * (all - rows) / rows);
}

void StageClock::end() {
  if (running_.empty()) return;
  seconds_.emplace_back(running_, secondsSince(since_));
  running_.clear();
  if (show_) std::fprintf(stderr, "\r\033[K");
}

std::string StageClock::json() const {
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [name, seconds] : seconds_) stages[name] = stages.value(name, 0.0) + seconds;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const nlohmann::ordered_json json = {
      {"stages", stages}, {"total", secondsSince(start_)}, {"peak_memory_bytes", usage.ru_maxrss * 1024}};
  return json.dump(2) + "\n";
}

}  // namespace tank_datum
