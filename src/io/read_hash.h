#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace tank_datum {

/// XXH3-128 of a file, taken from pieces of it as they are read: in any order, by any thread, some of them twice.
class ReadHash {
 public:
  ReadHash();
  ~ReadHash();
  ReadHash(const ReadHash&) = delete;
  ReadHash& operator=(const ReadHash&) = delete;

  /// Takes the bytes at an offset. Of what lies beyond the next ones a little is kept until these come.
  void take(std::uint64_t offset, std::string_view bytes);

  /// How many bytes from the beginning on are in the hash.
  std::uint64_t taken() const;

  /// Of these, as 32 lower-case hexadecimal digits, the canonical form of xxHash.
  std::string digest() const;

 private:
  struct State;

  /// Adds what is new of bytes that begin at or before the next ones.
  void add(std::uint64_t offset, std::string_view bytes);

  mutable std::mutex mutex_;
  std::unique_ptr<State> state_;
  std::uint64_t taken_ = 0;
  std::map<std::uint64_t, std::vector<char>> early_;  ///< pieces beyond taken_, by their offset
  std::size_t early_bytes_ = 0;
};

}  // namespace tank_datum
