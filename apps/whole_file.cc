#include "apps/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "apps/errors.h"

namespace apps {
namespace {

[[noreturn]] void refuse(const std::string& path, int error) {
  throw OutputError("cannot write '" + path + "': " + std::strerror(error));
}

// Returns 0 or the error of the call that failed.
int write_and_sync(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) == 0 ? 0 : errno;
}

// Writes `part`, then calls `put_in_place`, which returns 0 or an error.
template <class PutInPlace>
void write_beside(const std::string& path, std::string_view content, PutInPlace put_in_place) {
  const std::string part = path + ".part";
  const int descriptor = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse(path, errno);
  int error = write_and_sync(descriptor, content);
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0) error = put_in_place(part);
  if (error == 0) return;
  ::unlink(part.c_str());
  refuse(path, error);
}

int renamed(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

void write_whole_file(const std::string& path, std::string_view content) {
  write_beside(path, content, [&](const std::string& part) { return renamed(part, path); });
}

void replace_whole_file(const std::string& path, std::string_view content,
                        const std::string& older) {
  write_beside(path, content, [&](const std::string& part) {
    const int error = renamed(path, older);
    return error != 0 && error != ENOENT ? error : renamed(part, path);
  });
}

void claim_new_file(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse(path, errno);
  ::close(descriptor);
}

}  // namespace apps
