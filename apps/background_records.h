#pragma once

#include <algorithm>
#include <atomic>
#include <future>
#include <string>
#include <vector>

#include "io/scan_format.h"
#include "tank_datum/report/report.h"

namespace tank_datum {

/// The record of the input files. Hashes that the extraction does not take as it reads are taken in a thread beside it.
/// When the extraction fails nobody waits for them; where there is no thread to be had they are taken afterwards.
class BackgroundRecords {
 public:
  BackgroundRecords(const Scan& scan, Checksum checksum, int threads)
      : records_(std::async(
            threads != 1 && takesBeside(scan, checksum) ? std::launch::async | std::launch::deferred
                                                        : std::launch::deferred,
            [this, scan, checksum] { return recordInputs(scan, checksum, [this] { return wanted_.load(); }); })) {}
  ~BackgroundRecords() { wanted_ = false; }
  BackgroundRecords(const BackgroundRecords&) = delete;
  BackgroundRecords& operator=(const BackgroundRecords&) = delete;

  /// @throws Error (File) naming the file that cannot be read
  std::vector<InputRecord> take() { return records_.get(); }

 private:
  /// SHA-256 would hold up the threads that read; what somebody else reads is not seen.
  static bool takesBeside(const Scan& scan, Checksum checksum) {
    const auto is_foreign = [](const std::string& path) { return !foreignFormatOf(path).empty(); };
    return checksum == Checksum::Sha256 ||
           (checksum == Checksum::Xxh3 && std::any_of(scan.paths().begin(), scan.paths().end(), is_foreign));
  }

  std::atomic<bool> wanted_{true};
  std::future<std::vector<InputRecord>> records_;  // waits when destroyed, before wanted_ is
};

}  // namespace tank_datum
