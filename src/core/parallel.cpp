#include "core/parallel.h"

#include <algorithm>

#include "core/thread_pool.h"

namespace tank_datum {
namespace {

thread_local int scope_threads = 0;
thread_local const std::atomic<bool>* scope_given_up = nullptr;

}  // namespace

int threadCount(int threads) {
  if (threads > 0) return threads;
  return scope_threads > 0 ? scope_threads : ThreadPool::cores();
}

ThreadScope::ThreadScope(int threads) : outer_(scope_threads) {
  if (threads > 0) scope_threads = threads;
}

ThreadScope::~ThreadScope() { scope_threads = outer_; }

CancelScope::CancelScope(const std::atomic<bool>& given_up) : outer_(scope_given_up) { scope_given_up = &given_up; }

CancelScope::~CancelScope() { scope_given_up = outer_; }

void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  if (count == 0) return;
  const std::size_t wanted = ThreadPool::isAtWork() ? 1 : static_cast<std::size_t>(threadCount(threads));
  const auto* const given_up = scope_given_up;
  const std::function<void(std::size_t)> unless_given_up = [given_up, &work](std::size_t i) {
    if (given_up != nullptr && *given_up) throw GivenUp();
    work(i);
  };
  SharedWork shared(count, unless_given_up);
  ThreadPool::instance().share(shared, std::min(count, wanted) - 1);
  shared.rethrow();
}

void forEachRun(std::size_t count, int threads, const std::function<void(std::size_t, std::size_t)>& work) {
  constexpr std::size_t kRunsPerThread = 16;  // so that no thread waits long for the last one
  const std::size_t runs = std::min(count, kRunsPerThread * static_cast<std::size_t>(threadCount(threads)));
  forEachIndex(runs, threads, [&](std::size_t run) { work(count * run / runs, count * (run + 1) / runs); });
}

}  // namespace tank_datum
