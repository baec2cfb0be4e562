#include "core/thread_pool.h"

#include <omp.h>

#include <cstddef>
#include <memory>
#include <thread>

namespace tank_datum {
namespace {

thread_local bool at_work = false;

/// Bytes kept free while threads start: their stacks would else take all addresses there are, and OpenMP ends the
/// process where it cannot have a few hundred bytes.
constexpr std::size_t kLeftForWork = std::size_t{256} << 20;

/// The parallel regions that libraries open in the calling thread have one thread as long as this lives: FLANN opens
/// one for every query, each a team of threads that OpenMP ends the process for when it cannot have them.
class OneThreadRegions {
 public:
  OneThreadRegions() : outer_(omp_get_max_threads()) { omp_set_num_threads(1); }
  ~OneThreadRegions() { omp_set_num_threads(outer_); }
  OneThreadRegions(const OneThreadRegions&) = delete;
  OneThreadRegions& operator=(const OneThreadRegions&) = delete;

 private:
  int outer_;
};

}  // namespace

void SharedWork::run() noexcept {
  const OneThreadRegions regions;
  const bool outer = at_work;
  at_work = true;
  while (!thrown_) {
    const std::size_t i = next_.fetch_add(1);
    if (i >= count_) break;
    try {
      work_(i);
    } catch (...) {
      if (!thrown_.exchange(true)) reason_ = std::current_exception();
    }
  }
  at_work = outer;
}

void SharedWork::rethrow() const {
  if (thrown_) std::rethrow_exception(reason_);
}

ThreadPool& ThreadPool::instance() {
  static auto* pool = new ThreadPool;
  return *pool;
}

bool ThreadPool::isAtWork() { return at_work; }

int ThreadPool::cores() { return omp_get_max_threads(); }

void ThreadPool::growTo(std::size_t threads) {
  if (threads_ >= threads) return;
  try {
    const std::unique_ptr<std::byte[]> left(new std::byte[kLeftForWork]);
    for (; threads_ < threads; ++threads_) std::thread([this] { serve(); }).detach();
  } catch (const std::exception&) {  // no memory, or no more threads allowed: fewer do it too
  }
}

/// Under the lock: a work that wants one more helper.
SharedWork* ThreadPool::take() {
  if (first_ == nullptr) return nullptr;
  SharedWork* work = first_;
  ++work->helpers_;
  if (--work->helpers_wanted_ == 0) first_ = work->later_;
  return work;
}

void ThreadPool::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    SharedWork* work = take();
    if (work == nullptr) {
      wanted_.wait(lock);
      continue;
    }
    lock.unlock();
    work->run();
    lock.lock();
    if (--work->helpers_ == 0) work->helpers_gone_.notify_all();
  }
}

void ThreadPool::share(SharedWork& work, std::size_t helpers) {
  if (helpers == 0) return work.run();
  {
    const std::lock_guard lock(mutex_);
    growTo(helpers);
    work.helpers_wanted_ = helpers;
    work.later_ = first_;
    first_ = &work;
  }
  wanted_.notify_all();
  work.run();
  std::unique_lock lock(mutex_);
  for (SharedWork** at = &first_; *at != nullptr; at = &(*at)->later_) {
    if (*at != &work) continue;
    *at = work.later_;
    break;
  }
  work.helpers_gone_.wait(lock, [&] { return work.helpers_ == 0; });
}

}  // namespace tank_datum
