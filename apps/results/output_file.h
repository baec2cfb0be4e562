#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "results/staging.h"
#include "results/stop_signals.h"

namespace tank_datum {

/// Whether a file was written by a program before, judged by its content.
using IsOwn = std::function<bool(const std::string& path)>;

/// A JSON object with all of these keys.
IsOwn isJsonWith(std::vector<std::string> keys);
/// A file that begins with a text, and holds another one near its beginning.
IsOwn isFileWith(std::string beginning, std::string mark);
/// A report's page.
IsOwn isReportPage();

/// A file that a person named on the command line, which appears whole or not at all. A file of the same name that the
/// program wrote before is replaced; one of somebody else is kept under another name, with a line on stderr. A symbolic
/// link is followed; a device or a pipe is written to as it is.
class OutputFile {
 public:
  /// @throws Error (File) when the folder of the file cannot be written to or listed; Error (Option) for "-"
  OutputFile(const std::string& path, IsOwn own, std::string program);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Where to write it.
  std::string place() const;
  /// Writes it whole.
  /// @throws Error (File)
  void write(const std::string& content) const;
  /// Gives it its name.
  /// @throws Error (File)
  void commit();

 private:
  friend void commitTogether(const std::vector<OutputFile*>& files);
  static void commitIn(const std::string& folder, const std::vector<OutputFile*>& files);

  std::string path_, folder_, name_, program_;
  IsOwn own_;
  std::unique_ptr<results::Staging> staging_;  ///< none for a device
  std::unique_ptr<results::OnStop> on_stop_;
};

/// Gives several files their names; those of one folder appear together or not at all.
/// @throws Error (File)
void commitTogether(const std::vector<OutputFile*>& files);

}  // namespace tank_datum
