#include "io/sha256.h"

#include <openssl/sha.h>

#include <array>
#include <cstdint>
#include <vector>

#include "io/input_file.h"

namespace tank_datum {
namespace {

// libcrypto's newer calls ask for memory, and where there is none the library ends the process by SIGSEGV; these ask
// for none, and cannot fail.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
class Sha256 {
 public:
  Sha256() { SHA256_Init(&state_); }
  void add(const unsigned char* bytes, std::size_t count) { SHA256_Update(&state_, bytes, count); }
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest() {
    std::array<unsigned char, SHA256_DIGEST_LENGTH> bytes{};
    SHA256_Final(bytes.data(), &state_);
    return bytes;
  }

 private:
  SHA256_CTX state_{};
};
#pragma GCC diagnostic pop

}  // namespace

std::string sha256OfFile(const std::string& path, const std::function<bool()>& wanted) {
  const InputFile file(path);
  Sha256 hash;
  std::vector<unsigned char> block(std::size_t{1} << 20);
  std::uint64_t offset = 0;
  while (const std::size_t got = file.readSome(offset, block.data(), block.size())) {
    hash.add(block.data(), got);
    offset += got;
    if (wanted && !wanted()) return {};
  }

  std::string hex;
  for (const unsigned byte : hash.digest()) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

}  // namespace tank_datum
