#include "report/logo.h"

#include <openssl/evp.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "io/input_file.h"
#include "io/io_error.h"

namespace tank_datum {
namespace {

constexpr std::size_t kMegabyte = 1U << 20;
constexpr std::size_t kLargestPicture = 8;  // megabytes; the page carries it in itself

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

/// A file of at most so many megabytes, whole.
std::string fileUpTo(std::size_t megabytes, const std::string& path, const char* stage) {
  const InputFile file(path);
  if (file.size() > megabytes * kMegabyte) {
    throw Error(Error::Kind::File, stage,
                {echoPath(path), std::to_string(file.size()) + " bytes",
                 "a file of at most " + std::to_string(megabytes) + " MB", path});
  }
  return file.head(static_cast<std::size_t>(file.size()));
}

/// An image's bytes as a data URI.
/// @param named  for messages
std::string imageUri(const std::string& bytes, const char* stage, const std::string& named) {
  const std::string type = typeOf(bytes);
  if (type.empty()) {
    throw Error(Error::Kind::File, stage, named, "no image", "a PNG, JPEG, GIF, WebP or SVG image");
  }
  return "data:" + type + ";base64," + base64(bytes);
}

}  // namespace

std::string smallFile(const std::string& path) { return fileUpTo(1, path, "about"); }

std::string logoOf(const std::string& about, const std::string& name) {
  const std::string path = (std::filesystem::path(about).parent_path() / name).string();
  return imageUri(smallFile(path), "about", "logo " + echoPath(path));
}

std::string pictureOf(const std::string& path) {
  return imageUri(fileUpTo(kLargestPicture, path, "report"), "report", echoPath(path));
}

}  // namespace tank_datum
