// One writer per directory: two runs in one directory would each take the other's results for its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

#include "process/results/storage/result_file.h"

namespace diefill::results {

/// Another program is writing into the directory. The message is one line for people.
struct DirectoryInUse : ResultError {
  using ResultError::ResultError;
};

/// A directory locked for the life of this object, against other processes. The lock (fcntl, which network
/// mounts support as well) is on the file `.diefill-lock` in it, and ends with the process in any case; a
/// file left by a killed process has no effect. Reading needs no lock.
class DirectoryLock {
 public:
  /// Throws DirectoryInUse where another process holds the lock, ResultError where no file can be made.
  explicit DirectoryLock(const std::filesystem::path& directory);
  ~DirectoryLock();
  DirectoryLock(const DirectoryLock&) = delete;
  DirectoryLock& operator=(const DirectoryLock&) = delete;

  /// False where the file system knows no locks.
  bool held() const { return held_; }

 private:
  std::filesystem::path path_;
  int file_ = -1;
  bool held_ = true;
};

/// The process that has locked the directory, 0 where it is on another machine; nothing where none has.
std::optional<pid_t> lock_holder(const std::filesystem::path& directory);

/// Whether a process that had locked the directory was killed and none has locked it since. False where the
/// file system knows no locks.
bool left_by_a_killed_process(const std::filesystem::path& directory);

}  // namespace diefill::results
