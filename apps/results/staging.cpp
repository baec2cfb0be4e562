#include "results/staging.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <regex>
#include <thread>
#include <utility>
#include <vector>

#include "core/refusal.h"
#include "results/file_calls.h"
#include "results/journal.h"
#include "tank_datum/core/error.h"

namespace tank_datum::results {
namespace {

constexpr const char* kPrefix = ".tank_datum-";
constexpr std::chrono::milliseconds kPause(20);
constexpr int kPatience = 1500;  // pauses, 30 s; a commit takes a fraction of one

Error failure(const std::string& path, const std::string& reason, const char* expected) {
  return Error(Error::Kind::File, "report", path, reason, expected);
}

Error failure(const std::string& path, int reason, const char* expected) {
  return refusedBySystem("report", path, path, reason, expected);
}

/// Whether the run of a staging folder lives; unknown where the lock may not be opened.
enum class Owner { Lives, Gone, Unknown };

/// Asked where the file system has no locks: whether the process whose number the lock file holds lives here.
Owner ownerByNumber(int descriptor) {
  char text[16] = {};
  const pid_t process = ::pread(descriptor, text, sizeof text - 1, 0) > 0 ? std::atoi(text) : 0;
  return process > 0 && (::kill(process, 0) == 0 || errno != ESRCH) ? Owner::Lives : Owner::Gone;
}

std::string lockIn(const std::string& folder) { return folder + "/lock"; }

/// Whether the folder's lock is the open file, and not that of another run whose folder has the name now.
bool isLockOf(int descriptor, const std::string& folder) {
  struct stat mine {
  }, its{};
  return ::fstat(descriptor, &mine) == 0 && ::stat(lockIn(folder).c_str(), &its) == 0 && mine.st_ino == its.st_ino &&
         mine.st_dev == its.st_dev;
}

/// An open lock file, closed at the end.
class LockFile {
 public:
  /// @param how O_CREAT | O_EXCL to take over a folder whose lock is missing
  explicit LockFile(const std::string& folder, int how = 0)
      : descriptor_(::open(lockIn(folder).c_str(), O_RDWR | O_CLOEXEC | how, 0666)) {
    if (descriptor_ < 0) {
      owner_ = errno == ENOENT || errno == EEXIST ? Owner::Gone : Owner::Unknown;  // of none, then; isOf() says so
    } else if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      owner_ = errno == EWOULDBLOCK ? Owner::Lives : ownerByNumber(descriptor_);
    } else {
      owner_ = Owner::Gone;
    }
  }
  ~LockFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

  Owner owner() const { return owner_; }
  bool isOf(const std::string& folder) const { return descriptor_ >= 0 && isLockOf(descriptor_, folder); }

 private:
  int descriptor_;
  Owner owner_;
};

/// Removes what a run makes in its staging folder, and the folder if then empty; the lock last.
void removeOwn(const std::string& path) {
  for (const char* name : {"new", "old"}) removeTree(path + "/" + name);
  for (const char* name : {"journal.json.part", "done.json", "lock"}) removeFile(path + "/" + name);
  removeEmptyFolder(path);
}

/// Puts right what stands in the commit folder, whose owner is gone.
std::string putRight(const std::string& folder) {
  const std::string commit = folder + "/" + kCommitFolder;
  std::string said;
  if (const std::string text = contentOf(commit + "/journal.json"); !text.empty()) {
    try {
      for (const std::string& line : undo(folder, Journal::parsed(text, commit + "/journal.json"))) said += line + "\n";
    } catch (const Error& error) {
      throw failure(folder,
                    std::string("results incomplete since a run was stopped, and not to be put right: ") + error.what(),
                    "a folder that can be written to");
    }
    said = folder + ": a run was stopped while it replaced the results; those of the run before are back\n" + said;
  } else if (const std::string done = contentOf(commit + "/done.json"); !done.empty()) {
    throwAway(folder, Journal::parsed(done, commit + "/done.json"));
    said = folder + ": the last run was stopped after its results were in place; they are complete\n";
  }
  removeOwn(commit);
  return said;
}

}  // namespace

Staging::Staging(const std::string& folder) : folder_(folder) {
  static std::atomic<unsigned> counter{0};
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    if (begin(folder + "/" + kPrefix + std::to_string(::getpid()) + "-" + std::to_string(counter++))) return;
  }
  throw failure(folder, "no staging folder can be made", "a folder that can be written to");
}

bool Staging::begin(const std::string& path) {
  std::string here = path, own = path;  // what may fail for want of memory comes before what would be left over
  if (!makeFolder(path)) return false;
  path_ = std::move(here), own_name_ = std::move(own);
  try {
    lock_ = ::open(lockIn(path).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (lock_ < 0 && errno != ENOENT) {
      const int reason = errno;
      removeEmptyFolder(path);
      throw failure(path, reason, "a folder that can be written to");
    }
    const bool taken = lock_ < 0 || (::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK);
    if (taken || !isLockOf(lock_, path)) {  // another run took the folder for a stale one
      abandon();
      return false;
    }
    const std::string process = std::to_string(::getpid()) + "\n";
    if (::write(lock_, process.data(), process.size()) < 0) {
      throw failure(path, errno, "a folder with room for the results");
    }
    makeFolder(newFiles());
  } catch (...) {
    remove();
    throw;
  }
  return true;
}

Staging::~Staging() {
  remove();
  abandon();
}

void Staging::abandon() {
  if (lock_ >= 0) ::close(lock_);
  lock_ = -1;
  path_.clear();
  own_name_.clear();
}

void Staging::remove() noexcept {
  constexpr int kTries = 50;
  // the commit folder: its name is the next run's as soon as this one's folder has left it
  if (!path_.empty() && !own_name_.empty() && path_ != own_name_) {
    if (::rename(path_.c_str(), own_name_.c_str()) != 0) return abandon();
    path_ = std::move(own_name_);
    own_name_.clear();
  }
  for (int i = 0; i < kTries && !path_.empty(); ++i) {
    try {
      removeOwn(path_);
      if (!exists(path_)) path_.clear();
    } catch (const std::exception&) {
      if (lock_ >= 0) ::close(lock_);  // what is being removed needs no owner, and to look into it a descriptor
      lock_ = -1;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
}

std::string Staging::enterCommit() {
  std::string commit = folder_ + "/" + kCommitFolder, said;
  for (int i = 0; i < kPatience; ++i) {
    if (::rename(path_.c_str(), commit.c_str()) == 0) {
      path_ = std::move(commit);
      sync(folder_);
      return said;
    }
    if (errno != ENOTEMPTY && errno != EEXIST) {
      throw failure(commit, errno, "a folder that can be written to");
    }
    said += settle(folder_);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  throw failure(commit, "other runs' commits without end", "one run at a time");
}

void removeStale(const std::string& folder) {
  static const std::regex pattern(R"(\.tank_datum-[0-9]{1,9}-[0-9]{1,9})");
  DIR* listing = ::opendir(folder.c_str());
  if (listing == nullptr) throw failure(folder, errno, "a folder that can be listed");
  std::vector<std::string> found;
  while (const dirent* entry = ::readdir(listing)) {
    if (std::regex_match(entry->d_name, pattern)) found.emplace_back(entry->d_name);
  }
  ::closedir(listing);
  for (const std::string& name : found) {
    const std::string path = folder + "/" + name;
    if (kindOf(path) != Kind::Folder) continue;
    if (!exists(lockIn(path))) {
      removeEmptyFolder(path);  // of a run killed, or just about to make its lock: that one makes another folder
      continue;
    }
    const LockFile lock(path);
    if (lock.owner() == Owner::Gone && lock.isOf(path)) removeOwn(path);
  }
}

std::string settle(const std::string& folder) {
  const std::string commit = folder + "/" + kCommitFolder;
  for (int i = 0; i < kPatience; ++i) {
    if (kindOf(commit) != Kind::Folder) return {};
    const bool unlocked = !exists(lockIn(commit));
    if (unlocked && removeEmptyFolder(commit)) continue;  // of a run that has just removed its lock
    const LockFile lock(commit, unlocked ? O_CREAT | O_EXCL : 0);
    if (lock.owner() == Owner::Gone && lock.isOf(commit)) return putRight(folder);
    if (lock.owner() == Owner::Unknown) {
      throw failure(commit, "not to be opened",
                    "the results of a run that was stopped, in a folder that can be written to");
    }
    std::this_thread::sleep_for(kPause);
  }
  throw failure(commit, "another run that does not end", "one run at a time");
}

std::string settleToRead(const std::string& folder) {
  std::string said;
  for (const std::string& place : {folder, folder + "/.."}) {
    if (exists(place + "/" + kCommitFolder + "/journal.json")) said += settle(place);
  }
  return said;
}

}  // namespace tank_datum::results
