#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

#include "tank_datum/io/scan.h"

namespace tank_datum {

/// The blocks of one pass, all read by one thread of their own while the one before is looked at. Where the machine
/// gives no thread they are read when they are asked for.
class ReadAhead {
 public:
  explicit ReadAhead(ScanBlocks::Next next) : next_(std::move(next)) {}
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;
  ~ReadAhead();  ///< waits for the block that is being read

  /// Replaces the block by the next one, finished, or by its next rows where it is finished some at a time; false
  /// behind the last. Nothing is read ahead of the second call: many look at no more than the first block.
  /// @param block  what the call before gave, if there was one
  /// @throws what the source throws
  bool take(ScanBlocks::Block& block);

 private:
  bool fetch(ScanBlocks::Block& block);
  void start();
  void serve();

  ScanBlocks::Next next_;
  std::thread thread_;
  std::mutex mutex_;
  std::uint64_t asked_ = 0;  // blocks, by the taker
  std::condition_variable changed_;
  ScanBlocks::Block ready_;  // the thread's while is_ready_ is false, else the taker's
  bool is_ready_ = false;    // or there is no more, or it could not be read
  bool more_ = true;
  bool given_up_ = false;
  std::exception_ptr failure_;
  bool has_more_rows_ = false;  // the block that was taken
};

}  // namespace tank_datum
