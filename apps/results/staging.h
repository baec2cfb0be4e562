#pragma once

#include <string>

namespace tank_datum::results {

/// A hidden folder `.tank_datum-PID-N` inside the result folder, in which a run writes before it commits. A lock on a
/// file in it says that the run lives; the kernel gives it up with the process, however that ends.
class Staging {
 public:
  /// @throws Error (File) when the folder cannot be written to or listed
  explicit Staging(const std::string& folder);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::string& path() const { return path_; }
  /// Where the new files are written, in the places that they have in the result folder.
  std::string newFiles() const { return path_ + "/new"; }

  /// Renames the folder to kCommitFolder, of which there is one. Another run's commit is waited for; what a killed run
  /// left there is put right first.
  /// @return what was put right, a line each
  /// @throws Error (File)
  std::string enterCommit();

  /// Removes the folder and what is in it; tries again while somebody still writes into it.
  void remove() noexcept;
  /// Leaves everything as it is, for the next run to put right.
  void abandon();

 private:
  bool begin(const std::string& path);

  std::string folder_, path_, own_name_;
  int lock_ = -1;
};

/// Removes the staging folders of runs that live no more.
/// @throws Error (File) when the folder cannot be listed
void removeStale(const std::string& folder);

/// Puts a result folder right whose last commit was stopped: the earlier result comes back whole, or, where the new one
/// was whole already, its left-overs go. A commit that is under way is waited for.
/// @return what was done, a line each; nothing when there was nothing to do
/// @throws Error (File) when results are incomplete and this cannot be changed
std::string settle(const std::string& folder);

/// The same before results are read, of the folder and of the one it lies in, whose tank_N it may be; left-overs stay.
std::string settleToRead(const std::string& folder);

}  // namespace tank_datum::results
