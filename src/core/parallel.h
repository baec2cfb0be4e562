#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace tank_datum {

/// How many threads an option means: 0 is what the innermost ThreadScope of the calling thread says, all cores without
/// one.
int threadCount(int threads);

/// While it lives, `threads` = 0 means this number in the thread that made it: the chain sets it once from its option,
/// and the stages need not hand it down.
class ThreadScope {
 public:
  /// @param threads  0 leaves things as they are
  explicit ThreadScope(int threads);
  ~ThreadScope();
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope& operator=(const ThreadScope&) = delete;

 private:
  int outer_;
};

/// Thrown by what has been given up.
struct GivenUp {};

/// While it lives, the loops below that are begun by the thread that made it begin no more work once a flag is set.
class CancelScope {
 public:
  explicit CancelScope(const std::atomic<bool>& given_up);
  ~CancelScope();
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

 private:
  const std::atomic<bool>* outer_;
};

/// Calls work(i) for i = 0 .. count - 1, in any order, from several threads. With one thread none is started.
/// @param threads  see threadCount()
/// @throws what work throws first; the calls that had not begun are left out. GivenUp, see CancelScope
void forEachIndex(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

/// The same for much work of little cost each: work(begin, end) is given runs of consecutive indices that together are
/// 0 .. count - 1.
void forEachRun(std::size_t count, int threads, const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace tank_datum
