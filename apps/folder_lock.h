// A folder that one process at a time works in.
#pragma once

#include <string>

namespace apps {

// Held while it lives; the system frees it however the process ends.
class FolderLock {
 public:
  // Makes the folder where there is none. Throws OutputError, also where another process holds it.
  explicit FolderLock(const std::string& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;  // descriptor of the file `lock` in the folder
};

}  // namespace apps
