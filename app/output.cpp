#include "app/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "process/input/scene_error.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/result_file.h"

namespace diefill::app {

namespace {

std::string cannot_write(const std::filesystem::path& directory, const std::string& why,
                         const std::string& option) {
  return "cannot write to " + directory.string() + ": " + why + "; choose another directory with " + option;
}

}  // namespace

std::filesystem::path default_directory(const std::filesystem::path& file, const std::string& ending) {
  const std::string folder = std::filesystem::absolute(file).parent_path().filename().string();
  return std::filesystem::path("out") / (folder + '_' + file.stem().string() + ending);
}

void require_directory(const std::filesystem::path& directory, const std::string& option) {
  for (std::filesystem::path place = directory; place.has_relative_path(); place = place.parent_path()) {
    std::error_code error;
    const auto status = std::filesystem::status(place, error);
    if (error == std::errc::filename_too_long)
      throw process::SceneError(cannot_write(directory, "its name is too long", option));
    if (std::filesystem::is_directory(status)) return;
    if (std::filesystem::exists(status))
      throw process::SceneError(
          cannot_write(directory, place.string() + " is a file, not a directory", option));
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(place, error)))
      throw process::SceneError(
          cannot_write(directory, place.string() + " is a broken symbolic link", option));
  }
}

void require_writable(const std::filesystem::path& directory, const std::string& option) {
  std::error_code none;
  std::filesystem::path place = directory;
  while (place.has_relative_path() && !std::filesystem::exists(place, none)) place = place.parent_path();
  std::string file = ((place.empty() ? "." : place) / ".diefill-XXXXXX").string();
  const int made = ::mkstemp(file.data());
  if (made < 0)
    throw std::runtime_error(
        cannot_write(directory, std::error_code(errno, std::generic_category()).message(), option));
  ::close(made);
  ::unlink(file.c_str());
}

void make_output_directory(const std::filesystem::path& directory, const std::string& option) {
  require_directory(directory, option);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (!error && ::access(directory.c_str(), W_OK) != 0)
    error = std::error_code(errno, std::generic_category());
  if (error) throw std::runtime_error(cannot_write(directory, error.message(), option));
}

DirectoryToFill::DirectoryToFill(const std::filesystem::path& directory, const std::string& option) {
  std::error_code error;
  for (std::filesystem::path place = directory;
       place.has_relative_path() && !std::filesystem::exists(place, error); place = place.parent_path())
    made_.push_back(place);
  make_output_directory(directory, option);
}

DirectoryToFill::~DirectoryToFill() {
  std::error_code not_empty;
  for (const auto& place : made_) std::filesystem::remove(place, not_empty);
}

OutputDirectory::OutputDirectory(const std::filesystem::path& directory,
                                 const std::vector<std::string>& folders, const std::string& option) {
  make_output_directory(directory, option);
  try {
    lock_ = std::make_unique<results::DirectoryLock>(directory);
  } catch (const results::DirectoryInUse&) {
    throw;
  } catch (const results::ResultError& error) {
    throw std::runtime_error(std::string(error.what()) + "; choose another directory with " + option);
  }
  if (!lock_->held())
    std::fprintf(stderr,
                 "note: the file system of %s does not support locks: do not start a second run in it\n",
                 directory.c_str());
  results::remove_abandoned_files(directory);
  for (const std::string& folder : folders) results::remove_abandoned_files(directory / folder);
}

bool flush_standard_output() {
  errno = 0;
  std::cout.flush();
  const bool flushed = std::fflush(stdout) == 0;
  if (flushed && std::ferror(stdout) == 0 && std::cout.good()) return true;
  std::fprintf(stderr, "diefill: cannot write to standard output%s%s\n", errno == 0 ? "" : ": ",
               errno == 0 ? "" : std::strerror(errno));
  return false;
}

void write_output(const std::function<void()>& write) {
  try {
    write();
  } catch (const results::ResultError& error) {
    throw std::runtime_error(error.what());
  }
}

}  // namespace diefill::app
