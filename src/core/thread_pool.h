#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace tank_datum {

/// Work for indices that several threads take one after the other. It lives on the stack of the thread that asks for
/// it: nothing is allocated on the way, so that work goes on where there is no memory for more.
class SharedWork {
 public:
  SharedWork(std::size_t count, const std::function<void(std::size_t)>& work) : count_(count), work_(work) {}

  /// Takes indices until there are none, or until one of them has thrown.
  void run() noexcept;

  /// @throws what the work threw first
  void rethrow() const;

 private:
  friend class ThreadPool;

  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> thrown_{false};
  std::exception_ptr reason_;  // of the one that set thrown_

  // the pool's, under its lock
  SharedWork* later_ = nullptr;
  std::size_t helpers_wanted_ = 0, helpers_ = 0;
  std::condition_variable helpers_gone_;
};

/// Threads that wait for work. Where the machine gives no further ones those that there are do it, at worst the caller
/// alone. They are never joined: what waits at the end of the program ends with it.
class ThreadPool {
 public:
  static ThreadPool& instance();

  /// Runs the work in the caller's thread and in up to `helpers` others; returns when none is at it any more.
  void share(SharedWork& work, std::size_t helpers);

  /// As many threads as the environment wants in a parallel region (OMP_NUM_THREADS), all cores if it does not say.
  static int cores();

  /// Whether the calling thread is at shared work: what it shares again it does alone.
  static bool isAtWork();

 private:
  void growTo(std::size_t threads);
  void serve();
  SharedWork* take();

  std::mutex mutex_;
  std::condition_variable wanted_;
  SharedWork* first_ = nullptr;  // works that want helpers, by their later_
  std::size_t threads_ = 0;
};

}  // namespace tank_datum
