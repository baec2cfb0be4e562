#include "io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "io/io_error.h"
#include "io/read_hash.h"

namespace tank_datum {
namespace {

/// File systems stamp times by a clock that ticks every few milliseconds. A file written to within the last tick is
/// waited for: whatever is written from then on has another time.
void waitOutTick(const struct timespec& written) {
  using Clock = std::chrono::system_clock;
  constexpr std::chrono::milliseconds kTick(10);
  const auto since_epoch = std::chrono::seconds(written.tv_sec) + std::chrono::nanoseconds(written.tv_nsec);
  const Clock::duration age = Clock::now().time_since_epoch() - since_epoch;
  if (age >= Clock::duration::zero() && age < kTick) std::this_thread::sleep_for(kTick - age);
}

}  // namespace

bool InputFile::State::operator==(const State& other) const {
  return device == other.device && number == other.number && size == other.size && seconds == other.seconds &&
         nanoseconds == other.nanoseconds;
}

InputFile::State InputFile::stateOf(const struct stat& status) {
  return {status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size), status.st_mtim.tv_sec,
          status.st_mtim.tv_nsec};
}

InputFile::InputFile(std::string path, bool hashed)
    : path_(std::move(path)), hash_(hashed ? std::make_unique<ReadHash>() : nullptr) {
  // O_NONBLOCK: a pipe with nobody at the other end is refused below instead of waited for
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) throw fileError("opening", path_, errno, "a file that can be read");
  struct stat status {};
  const bool known = ::fstat(descriptor_, &status) == 0;
  if (!known || !S_ISREG(status.st_mode)) {
    ::close(descriptor_);
    throw fileError("opening", path_, known && S_ISDIR(status.st_mode) ? "a folder" : "not a regular file",
                    "a file that can be read");
  }
  opened_ = stateOf(status);
  waitOutTick(status.st_mtim);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::readSome(std::uint64_t offset, void* to, std::size_t count) const {
  const std::size_t got = readBytes(offset, to, count);
  if (hash_) hash_->take(offset, {static_cast<const char*>(to), got});
  return got;
}

std::size_t InputFile::readBytes(std::uint64_t offset, void* to, std::size_t count) const {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        ::pread(descriptor_, static_cast<char*>(to) + done, count - done, static_cast<off_t>(offset + done));
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw fileError("reading", path_, errno, "a file that can be read");
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::string InputFile::head(std::size_t count) const {
  std::string bytes(std::min<std::uint64_t>(count, size()), '\0');
  bytes.resize(readSome(0, bytes.data(), bytes.size()));
  return bytes;
}

void InputFile::requireUnchanged() const {
  struct stat named {
  }, open{};
  const bool known = ::stat(path_.c_str(), &named) == 0 && ::fstat(descriptor_, &open) == 0;
  if (known && stateOf(named) == opened_ && stateOf(open) == opened_) return;
  throw fileError("reading", path_, "changed meanwhile", "a file that nobody writes, moves or removes during the run");
}

std::string InputFile::xxh3(const std::function<bool()>& wanted) const {
  ReadHash whole;
  ReadHash& hash = hash_ ? *hash_ : whole;
  std::vector<char> block(std::size_t{1} << 20);
  while (true) {
    const std::uint64_t taken = hash.taken();
    const std::size_t got = readBytes(taken, block.data(), block.size());
    if (got == 0) return hash.digest();
    hash.take(taken, {block.data(), got});
    if (wanted && !wanted()) return {};
  }
}

void InputFile::read(std::uint64_t offset, void* to, std::size_t count) const {
  const std::size_t got = readSome(offset, to, count);
  if (got < count) {
    throw fileError("size", path_, std::to_string(offset + got) + " bytes",
                    "at least " + std::to_string(offset + count) + " (cut short while reading?)");
  }
}

}  // namespace tank_datum
