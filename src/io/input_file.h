#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

struct stat;

namespace tank_datum {

class ReadHash;

/// A regular file open for reading at any place; several threads may read at once. Reading instead of mapping it
/// makes a file cut short meanwhile an Error, not a signal.
class InputFile {
 public:
  /// @throws Error (File) when path is missing, not readable, a folder or a device
  /// @param hashed  take the hash of what is read
  explicit InputFile(std::string path, bool hashed = false);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }

  /// Bytes when it was opened.
  std::uint64_t size() const { return opened_.size; }

  /// Reads up to count bytes from offset on; fewer only at the end of the file.
  /// @throws Error (File) when the device fails
  std::size_t readSome(std::uint64_t offset, void* to, std::size_t count) const;

  /// The first bytes, as many as asked for or as there are.
  /// @throws Error (File) when the device fails
  std::string head(std::size_t count) const;

  /// Reads exactly count bytes.
  /// @throws Error (File) when the file is shorter
  void read(std::uint64_t offset, void* to, std::size_t count) const;

  /// Whether the path still names this file, as long as it was and not written to since it was opened.
  /// @throws Error (File) when it does not: what was read before and after need not belong together
  void requireUnchanged() const;

  /// XXH3-128 of the bytes, see Scan::hashOf.
  /// @throws Error (File) when the device fails
  std::string xxh3(const std::function<bool()>& wanted = {}) const;

 private:
  std::size_t readBytes(std::uint64_t offset, void* to, std::size_t count) const;

  /// How a change of the file shows.
  struct State {
    std::uint64_t device = 0, number = 0, size = 0;
    std::int64_t seconds = 0, nanoseconds = 0;  ///< when it was last written to

    bool operator==(const State& other) const;
  };
  static State stateOf(const struct stat& status);

  std::string path_;
  int descriptor_ = -1;
  State opened_;
  std::unique_ptr<ReadHash> hash_;  ///< of what has been read; none: of a file that is not hashed
};

}  // namespace tank_datum
