#include "report/logo.h"

#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "io/input_file.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kLargest = 1U << 20;  // bytes; the page carries it in itself

/// The media type by how the file begins; empty: none that browsers show.
std::string typeOf(const std::string& bytes) {
  const auto begins = [&](const std::string& with, std::size_t at = 0) {
    return bytes.compare(at, with.size(), with) == 0;
  };
  if (begins("\x89PNG")) return "image/png";
  if (begins("\xFF\xD8\xFF")) return "image/jpeg";
  if (begins("GIF8")) return "image/gif";
  if (begins("RIFF") && begins("WEBP", 8)) return "image/webp";
  const std::string head = bytes.substr(0, 1000);
  return head.find("<svg") != std::string::npos ? "image/svg+xml" : "";
}

std::string base64(const std::string& bytes) {
  std::vector<unsigned char> text(4 * ((bytes.size() + 2) / 3) + 1);
  const int length = EVP_EncodeBlock(text.data(), reinterpret_cast<const unsigned char*>(bytes.data()),
                                     static_cast<int>(bytes.size()));
  return {text.begin(), text.begin() + length};
}

}  // namespace

std::string smallFile(const std::string& path) {
  const InputFile file(path);
  if (file.size() > kLargest) {
    throw Error(Error::Kind::File, "about", echoPath(path), std::to_string(file.size()) + " bytes",
                "a file of at most 1 MB");
  }
  return file.head(static_cast<std::size_t>(file.size()));
}

std::string logoOf(const std::string& about, const std::string& name) {
  const std::string path = (std::filesystem::path(about).parent_path() / name).string();
  const std::string bytes = smallFile(path), type = typeOf(bytes);
  if (type.empty()) {
    throw Error(Error::Kind::File, "about", "logo " + echoPath(path), "no image",
                "a PNG, JPEG, GIF, WebP or SVG image");
  }
  return "data:" + type + ";base64," + base64(bytes);
}

}  // namespace tank_datum
