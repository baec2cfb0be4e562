#include "results/file_calls.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/refusal.h"
#include "tank_datum/core/error.h"

namespace tank_datum::results {
namespace {

namespace fs = std::filesystem;

Error failure(const std::string& path, int reason, const char* expected = "a folder that can be written to") {
  return refusedBySystem("report", path, path, reason, expected);
}

}  // namespace

Kind kindOf(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return Kind::Nothing;
    throw failure(path, errno, "a folder that can be looked into");
  }
  return S_ISREG(status.st_mode) ? Kind::File : S_ISDIR(status.st_mode) ? Kind::Folder : Kind::Other;
}

bool makeFolder(const std::string& path) {
  if (::mkdir(path.c_str(), 0777) == 0) return true;
  if (errno == EEXIST) return false;
  throw failure(path, errno);
}

void move(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) throw failure(to, errno);
  if (exists(to)) throw failure(to, EEXIST);  // a file system that cannot refuse by itself
  if (::rename(from.c_str(), to.c_str()) != 0) throw failure(to, errno);
}

void removeFile(const std::string& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) throw failure(path, errno);
}

void removeTree(const std::string& path) {
  std::error_code failed;
  fs::remove_all(path, failed);
  if (failed) throw failure(path, failed.value());
}

bool removeEmptyFolder(const std::string& path) noexcept { return ::rmdir(path.c_str()) == 0 || errno == ENOENT; }

void writeSynced(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw failure(path, errno != 0 ? errno : EIO, "a writable folder with room for the results");
  sync(path);
}

void sync(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw failure(path, errno);
  const int reason = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  // some network shares cannot do it for folders
  if (reason != 0 && reason != EINVAL && reason != ENOTSUP) throw failure(path, reason);
}

std::string contentOf(const std::string& path) {
  if (kindOf(path) != Kind::File) return {};
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string content;
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0) content.append(block, static_cast<std::size_t>(in.gcount()));
  if (!in.eof()) throw failure(path, errno != 0 ? errno : EIO, "a file that can be read");
  return content;
}

bool inRealFolders(const std::string& folder, const std::string& path) {
  std::string way = folder;
  for (const fs::path& part : fs::path(path).parent_path()) {
    way += "/" + part.string();
    if (kindOf(way) != Kind::Folder) return false;
  }
  return true;
}

std::string keptName(const std::string& path) {
  const fs::path whole(path);
  for (int count = 1;; ++count) {
    const std::string mark = count == 1 ? ".kept" : ".kept-" + std::to_string(count);
    const std::string name = whole.stem().string() + mark + whole.extension().string();
    const std::string kept = (whole.parent_path() / name).string();
    if (!exists(kept)) return kept;
  }
}

}  // namespace tank_datum::results
