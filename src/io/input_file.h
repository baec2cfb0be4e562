#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

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
  std::uint64_t size() const { return size_; }

  /// Reads up to count bytes from offset on; fewer only at the end of the file.
  /// @throws Error (File) when the device fails
  std::size_t readSome(std::uint64_t offset, void* to, std::size_t count) const;

  /// The first bytes, as many as asked for or as there are.
  /// @throws Error (File) when the device fails
  std::string head(std::size_t count) const;

  /// Reads exactly count bytes.
  /// @throws Error (File) when the file is shorter
  void read(std::uint64_t offset, void* to, std::size_t count) const;

  /// XXH3-128 of the bytes, see Scan::hashOf.
  /// @throws Error (File) when the device fails
  std::string xxh3(const std::function<bool()>& wanted = {}) const;

 private:
  std::size_t readBytes(std::uint64_t offset, void* to, std::size_t count) const;

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::unique_ptr<ReadHash> hash_;  ///< of what has been read; none: of a file that is not hashed
};

}  // namespace tank_datum
