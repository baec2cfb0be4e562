#include "io/read_ahead.h"

#include <system_error>
#include <utility>

namespace tank_datum {

ReadAhead::~ReadAhead() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    given_up_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

bool ReadAhead::take(ScanBlocks::Block& block) {
  if (!has_more_rows_ && !fetch(block)) return false;
  has_more_rows_ = block.finish && block.finish(block);
  return true;
}

bool ReadAhead::fetch(ScanBlocks::Block& block) {
  if (asked_ == 0) start();
  std::unique_lock<std::mutex> lock(mutex_);
  ++asked_;
  if (!thread_.joinable()) return next_(block);
  changed_.notify_one();
  changed_.wait(lock, [this] { return is_ready_; });
  if (failure_) std::rethrow_exception(failure_);
  if (!more_) return false;
  std::swap(block, ready_);
  is_ready_ = false;
  changed_.notify_one();
  return true;
}

void ReadAhead::start() {
  try {
    thread_ = std::thread([this] { serve(); });
  } catch (const std::system_error&) {
    // no thread to be had
  }
}

void ReadAhead::serve() {
  for (bool more = true; more;) {
    std::exception_ptr failure;
    try {
      more = next_(ready_);
    } catch (...) {
      more = false;
      failure = std::current_exception();
    }
    std::unique_lock<std::mutex> lock(mutex_);
    more_ = more, failure_ = failure, is_ready_ = true;
    changed_.notify_one();
    changed_.wait(lock, [this] { return (!is_ready_ && asked_ > 1) || given_up_; });
    if (given_up_) return;
  }
}

}  // namespace tank_datum
