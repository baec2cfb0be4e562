#pragma once

#include <atomic>
#include <future>
#include <string>
#include <vector>

#include "command_line.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// The record of the input files, made in a thread of its own while the datum is extracted. When the extraction fails
/// nobody waits for it.
class BackgroundRecords {
 public:
  /// @param command  the files, how they are read, and whether their SHA-256 is wanted, which of one file only one
  ///                 core can take
  /// @param at_once  begin now; else only when they are taken
  BackgroundRecords(const Command& command, bool at_once)
      : wanted_(!command.no_checksum),
        records_(std::async(at_once ? std::launch::async : std::launch::deferred,
                            [this, paths = command.scans, reading = command.reading] {
                              return recordInputs(
                                  paths, [this] { return wanted_.load(); }, reading);
                            })) {}
  ~BackgroundRecords() { wanted_ = false; }
  BackgroundRecords(const BackgroundRecords&) = delete;
  BackgroundRecords& operator=(const BackgroundRecords&) = delete;

  /// @throws Error (File) naming the file that cannot be read
  std::vector<InputRecord> take() { return records_.get(); }

 private:
  std::atomic<bool> wanted_;
  std::future<std::vector<InputRecord>> records_;  // waits when destroyed, before wanted_ is
};

}  // namespace tank_datum
