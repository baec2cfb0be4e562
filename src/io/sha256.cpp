#include "io/sha256.h"

#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "io/input_file.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

void require(int openssl_result, const std::string& path) {
  if (openssl_result != 1) throw fileError("SHA-256", path, "libcrypto failed", "a digest");
}

}  // namespace

std::string sha256OfFile(const std::string& path, const std::function<bool()>& wanted) {
  const InputFile file(path);
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  require(context ? EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) : 0, path);

  std::vector<unsigned char> block(std::size_t{1} << 20);
  std::uint64_t offset = 0;
  while (const std::size_t got = file.readSome(offset, block.data(), block.size())) {
    require(EVP_DigestUpdate(context.get(), block.data(), got), path);
    offset += got;
    if (wanted && !wanted()) return {};
  }

  std::array<unsigned char, 32> digest{};
  require(EVP_DigestFinal_ex(context.get(), digest.data(), nullptr), path);
  std::string hex;
  for (const unsigned byte : digest) {
    hex += "0123456789abcdef"[byte >> 4];
    hex += "0123456789abcdef"[byte & 15];
  }
  return hex;
}

}  // namespace tank_datum
