#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "results/result_folder.h"
#include "support/test_folder.h"

namespace tank_datum {

namespace fs = std::filesystem;

/// A folder that goes with the test, and runs of a program that write results into it.
class ResultFolderFixture : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (dir_ / name).string(); }
  bool has(const std::string& name) const { return fs::exists(fs::symlink_status(dir_ / name)); }
  std::string read(const std::string& name) const {
    std::ifstream in(dir_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& name, const std::string& content) const {
    fs::create_directories((dir_ / name).parent_path());
    std::ofstream(dir_ / name) << content;
  }
  /// A run that writes files, each with a content, into out/.
  void run(const std::vector<std::pair<std::string, std::string>>& files, const std::string& program = "tank_datum") {
    ResultFolder folder(path("out"), program);
    for (const auto& [name, content] : files) {
      const fs::path file(name);
      std::ofstream(folder.stage(file.parent_path().string()) + "/" + file.filename().string()) << content;
    }
    testing::internal::CaptureStderr();
    folder.commit();
    said_ = testing::internal::GetCapturedStderr();
  }
  std::size_t entries(const std::string& name) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(dir_ / name), fs::directory_iterator()));
  }

  TestFolder folder_;
  const fs::path& dir_ = folder_.root();
  std::string said_;
};

}  // namespace tank_datum
