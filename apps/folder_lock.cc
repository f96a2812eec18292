#include "apps/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "apps/errors.h"

namespace apps {

FolderLock::FolderLock(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError(folder + ": cannot be created: " + error.message());
  file_ = ::open((folder + "/lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw OutputError(folder + ": cannot be written: " + std::strerror(errno));
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  const int trouble = errno;
  ::close(file_);
  if (trouble == EWOULDBLOCK)
    throw OutputError(folder +
                      ": another process runs here; wait for its end or choose another --out");
  throw OutputError(folder + ": cannot be locked: " + std::strerror(trouble));
}

FolderLock::~FolderLock() {
  ::close(file_);
}

}  // namespace apps
