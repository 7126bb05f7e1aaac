#include "process/results/storage/directory_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

namespace diefill::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLockFile = ".diefill-lock";  // a name of its own: it is removed at the end

struct flock whole_file() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

std::optional<pid_t> holder_of(int file) {
  struct flock lock = whole_file();
  if (::fcntl(file, F_GETLK, &lock) != 0 || lock.l_type == F_UNLCK) return std::nullopt;
  return std::max<pid_t>(lock.l_pid, 0);
}

/// Whether the file that was opened is still the one of this name: its holder removes it at the end.
bool lies_at(int file, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

[[noreturn]] void refuse(const fs::path& directory, std::optional<pid_t> holder) {
  const std::string who = holder.value_or(0) > 0 ? " (process " + std::to_string(*holder) + ")" : "";
  throw DirectoryInUse(directory.string() + ": locked, another run" + who +
                       " is writing to it; wait until it ends or choose another directory with --out");
}

}  // namespace

DirectoryLock::DirectoryLock(const fs::path& directory) : path_(directory / kLockFile) {
  for (;;) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) throw ResultError("cannot lock " + directory.string() + ": " + std::strerror(errno));
    struct flock lock = whole_file();
    const bool locked = ::fcntl(file_, F_SETLK, &lock) == 0;
    if (!locked && (errno == EACCES || errno == EAGAIN)) {
      const auto holder = holder_of(file_);
      ::close(file_);
      refuse(directory, holder);
    }
    held_ = locked;
    if (!locked || lies_at(file_, path_)) return;
    ::close(file_);
  }
}

DirectoryLock::~DirectoryLock() {
  ::unlink(path_.c_str());
  ::close(file_);
}

std::optional<pid_t> lock_holder(const fs::path& directory) {
  const int file = ::open((directory / kLockFile).c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return std::nullopt;
  const auto holder = holder_of(file);
  ::close(file);
  return holder;
}

bool left_by_a_killed_process(const fs::path& directory) {
  const int file = ::open((directory / kLockFile).c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return false;
  struct flock lock = whole_file();
  const bool taken = ::fcntl(file, F_SETLK, &lock) == 0;
  ::close(file);
  return taken;
}

}  // namespace diefill::results
