#include "print/profile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "tank_datum/core/error.h"

namespace tank_datum {
namespace {

namespace fs = std::filesystem;

const std::string kPrefix = "tank_datum_print_";

std::string lockOf(const fs::path& folder) { return (folder / "lock").string(); }

/// The lock of a folder, held; -1 where another process holds it or there is none.
int taken(const fs::path& folder, int flags) {
  const int lock = open(lockOf(folder).c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (lock >= 0 && flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
  if (lock >= 0) close(lock);
  return -1;
}

/// Whether a folder is one of this user's own.
bool isOwnFolder(const fs::path& path) {
  struct stat found {};
  return lstat(path.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid();
}

void removeStale(const fs::path& temporary) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(temporary, ignored)) {
    const fs::path& path = entry.path();
    if (path.filename().string().rfind(kPrefix, 0) != 0 || !isOwnFolder(path)) continue;
    const int lock = taken(path, 0);
    if (lock < 0) continue;
    fs::remove_all(path, ignored);
    close(lock);
  }
}

}  // namespace

Profile::Profile() {
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  if (!failed) removeStale(temporary);
  path_ = (temporary / (kPrefix + "XXXXXX")).string();
  if (failed || mkdtemp(path_.data()) == nullptr) {
    throw Error(Error::Kind::File, "pdf", path_, "not made", "room in the folder for temporary files");
  }
  lock_ = taken(path_, O_CREAT);
}

Profile::~Profile() {
  remove();
  if (lock_ >= 0) close(lock_);
}

void Profile::remove() const noexcept {
  std::error_code ignored;
  for (int attempt = 0; attempt < 3; ++attempt) fs::remove_all(path_, ignored);  // a browser that ends may still write
}

}  // namespace tank_datum
