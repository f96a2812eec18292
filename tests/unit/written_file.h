// Files of a test, in a folder of their own that goes when the test is over.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace tests {

class WrittenFiles {
 public:
  WrittenFiles() {
    std::string name = std::filesystem::temp_directory_path() / ("gyratory-" + std::string(6, 'X'));
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for the files of a test");
    folder_ = name;
  }
  ~WrittenFiles() { std::filesystem::remove_all(folder_); }
  WrittenFiles(const WrittenFiles&) = delete;
  WrittenFiles& operator=(const WrittenFiles&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // The path of the file written.
  std::string write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace tests
