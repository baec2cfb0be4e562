#pragma once

#include <string>

namespace tank_datum {

/// A folder for a browser's own files, in the folder for temporary ones, gone with this. A lock on a file in it says
/// that its process lives; the kernel gives it up with the process, however that ends.
class Profile {
 public:
  /// Removes the folders of processes that live no more, too.
  /// @throws Error (File) when it cannot be made
  Profile();
  ~Profile();
  Profile(const Profile&) = delete;
  Profile& operator=(const Profile&) = delete;

  const std::string& path() const { return path_; }
  void remove() const noexcept;

 private:
  std::string path_;
  int lock_ = -1;
};

}  // namespace tank_datum
