#include "core/parallel.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <exception>

namespace tank_datum {
namespace {

thread_local int scope_threads = 0;

}  // namespace

int threadCount(int threads) {
  if (threads > 0) return threads;
  return scope_threads > 0 ? scope_threads : omp_get_max_threads();
}

ThreadScope::ThreadScope(int threads) : outer_(scope_threads) {
  if (threads > 0) scope_threads = threads;
}

ThreadScope::~ThreadScope() { scope_threads = outer_; }

void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const int wanted = threadCount(threads);
  if (wanted == 1) {
    for (std::size_t i = 0; i < count; ++i) work(i);
    return;
  }
  std::exception_ptr thrown;
  std::atomic<bool> stop{false};
#pragma omp parallel for schedule(dynamic) num_threads(wanted)
  for (std::size_t i = 0; i < count; ++i) {
    if (stop) continue;
    try {
      work(i);
    } catch (...) {  // none may leave the parallel region
      if (!stop.exchange(true)) thrown = std::current_exception();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
}

void forEachRun(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work) {
  constexpr std::size_t kRunsPerThread = 16;  // so that no thread waits long for the last one
  const std::size_t runs = std::min(count, kRunsPerThread * static_cast<std::size_t>(threadCount(threads)));
  forEachIndex(runs, threads, [&](std::size_t run) { work(count * run / runs, count * (run + 1) / runs); });
}

}  // namespace tank_datum
