#pragma once

#include <memory>
#include <string>

#include "results/staging.h"
#include "results/stop_signals.h"

namespace tank_datum::bench {

/// A folder of its own inside another, gone with its owner or when the program is stopped: what stands in the one named
/// is somebody else's.
class ScratchFolder {
 public:
  /// @throws Error (File) when the folder cannot be written to or listed
  explicit ScratchFolder(const std::string& folder);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path() const { return staging_->newFiles(); }

 private:
  std::unique_ptr<results::Staging> staging_;
  std::unique_ptr<results::OnStop> on_stop_;
};

}  // namespace tank_datum::bench
