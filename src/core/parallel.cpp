#include "tank_datum/core/parallel.h"

#include <omp.h>

#include <atomic>
#include <exception>

namespace tank_datum {

int threadCount(int threads) { return threads > 0 ? threads : omp_get_max_threads(); }

void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  std::exception_ptr thrown;
  std::atomic<bool> stop{false};
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
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

}  // namespace tank_datum
