#pragma once

#include <string>
#include <vector>

namespace tank_datum {

/// A folder that receives a set of result files whole or not at all.
///
/// Files are written into a hidden folder inside it and renamed by commit(). Without commit() nothing new appears, and
/// the results of an earlier run move to `previous/`, so that they cannot be taken for this run's.
class ResultFolder {
 public:
  /// The files of tank_datum's results.
  static std::vector<std::string> resultNames();

  /// Makes the folder if it is missing.
  /// @param names  the files that an earlier run may have left
  /// @throws Error (File) when it cannot be made or written to
  explicit ResultFolder(std::string path, std::vector<std::string> names = resultNames());
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  /// Where to write the files of a part of the results: `name` is a folder such as "tank_1", or "" for the folder
  /// itself.
  /// @throws Error (File) when it cannot be made
  std::string stage(const std::string& name) const;

  /// Takes away the files of an earlier run and renames the new ones to their places.
  /// @throws Error (File)
  void commit();

 private:
  /// Result files of an earlier run, relative to the folder: its own and those of its tank_N.
  std::vector<std::string> earlier() const;

  std::string path_, staging_;
  std::vector<std::string> names_;
  bool made_ = false, committed_ = false;
};

}  // namespace tank_datum
