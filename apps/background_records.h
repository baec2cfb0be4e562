#pragma once

#include <atomic>
#include <future>
#include <string>
#include <vector>

#include "tank_datum/report/report.h"

namespace tank_datum {

/// The record of the input files, made in a thread of its own while the datum is extracted. When the extraction fails
/// nobody waits for it.
class BackgroundRecords {
 public:
  /// @param reading    how the files are read
  /// @param at_once    begin now; else only when they are taken
  /// @param checksums  take the files' SHA-256, which of one file only one core can
  BackgroundRecords(const std::vector<std::string>& paths, const ScanOptions& reading, bool at_once, bool checksums)
      : wanted_(checksums),
        records_(std::async(at_once ? std::launch::async : std::launch::deferred, [this, paths, reading] {
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
