// results.h5 of a run, to be read.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace apps {

class HistoryFile {
 public:
  // Throws OutputError, as all of it does, where the file cannot be read.
  explicit HistoryFile(const std::string& path);
  ~HistoryFile();

  bool has(const std::string& column) const;
  std::vector<double> column(const std::string& name) const;  // /history/<name>, row by row

 private:
  struct File;
  std::unique_ptr<File> file_;
};

}  // namespace apps
