#include "io/read_hash.h"

#include <xxhash.h>

#include <new>

namespace tank_datum {
namespace {

// Threads that read block after block are at most a few blocks ahead of the last of them.
constexpr std::size_t kMostEarly = std::size_t{64} << 20;  // bytes

}  // namespace

struct ReadHash::State {
  State() : xxh(XXH3_createState()) {
    if (xxh == nullptr || XXH3_128bits_reset(xxh) != XXH_OK) throw std::bad_alloc();
  }
  ~State() { XXH3_freeState(xxh); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  XXH3_state_t* xxh;
};

ReadHash::ReadHash() : state_(std::make_unique<State>()) {}

ReadHash::~ReadHash() = default;

void ReadHash::take(std::uint64_t offset, std::string_view bytes) {
  const std::lock_guard<std::mutex> alone(mutex_);
  if (offset + bytes.size() <= taken_) return;
  if (offset > taken_) {
    if (early_bytes_ + bytes.size() > kMostEarly || early_.count(offset) != 0) return;
    early_.emplace(offset, std::vector<char>(bytes.begin(), bytes.end()));
    early_bytes_ += bytes.size();
    return;
  }
  add(offset, bytes);
  while (!early_.empty() && early_.begin()->first <= taken_) {
    const auto& [begin, kept] = *early_.begin();
    add(begin, {kept.data(), kept.size()});
    early_bytes_ -= kept.size();
    early_.erase(early_.begin());
  }
}

void ReadHash::add(std::uint64_t offset, std::string_view bytes) {
  const std::uint64_t known = taken_ - offset;
  if (known >= bytes.size()) return;
  bytes.remove_prefix(static_cast<std::size_t>(known));
  XXH3_128bits_update(state_->xxh, bytes.data(), bytes.size());
  taken_ += bytes.size();
}

std::uint64_t ReadHash::taken() const {
  const std::lock_guard<std::mutex> alone(mutex_);
  return taken_;
}

std::string ReadHash::digest() const {
  const std::lock_guard<std::mutex> alone(mutex_);
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_->xxh));
  std::string hex;
  for (const unsigned byte : canonical.digest) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

}  // namespace tank_datum
