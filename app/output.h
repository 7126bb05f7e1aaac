// Where the program's files go, and what it says when they cannot be written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "process/results/storage/directory_lock.h"

namespace diefill::app {

/// Where results of a command on this file go unless the user says otherwise: out/<folder of the file>_<its
/// name><ending>.
std::filesystem::path default_directory(const std::filesystem::path& file, const std::string& ending = {});

/// Throws process::SceneError, in one line that names `option`, where a file stands at this place or above
/// it. Makes nothing.
void require_directory(const std::filesystem::path& directory, const std::string& option = "--out");

/// Throws std::runtime_error, in one line, where no file can be made in the directory, or in the one above it
/// where it is to be made. A file is made there and removed: permissions alone do not tell.
void require_writable(const std::filesystem::path& directory, const std::string& option = "--out");

/// Makes the directory, with those above it, before hours are spent on what is to go there. Throws as
/// require_directory(), and std::runtime_error, in one line, when it cannot be made or written to.
void make_output_directory(const std::filesystem::path& directory, const std::string& option = "--out");

/// A directory made as above for files that may come to nothing: where it is empty at the end, it and those
/// above it that were made for it are removed again.
class DirectoryToFill {
 public:
  explicit DirectoryToFill(const std::filesystem::path& directory, const std::string& option = "--out");
  ~DirectoryToFill();
  DirectoryToFill(const DirectoryToFill&) = delete;
  DirectoryToFill& operator=(const DirectoryToFill&) = delete;

 private:
  std::vector<std::filesystem::path> made_;  ///< deepest first
};

/// A directory made as above and this command's own for the life of this object; temporary files of killed
/// runs are removed from it and its `folders`. Throws results::DirectoryInUse where another program writes
/// into it.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::filesystem::path& directory,
                           const std::vector<std::string>& folders = {}, const std::string& option = "--out");

 private:
  std::unique_ptr<results::DirectoryLock> lock_;
};

/// Flushes standard output. Returns whether all that was written has got there; where not, prints the reason
/// on standard error, in one line.
bool flush_standard_output();

/// Calls `write`. A results::ResultError of writing, as on a full disk, goes on as a std::runtime_error: not
/// the scene's fault.
void write_output(const std::function<void()>& write);

}  // namespace diefill::app
