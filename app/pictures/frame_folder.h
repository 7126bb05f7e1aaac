// The folder of a film's frames while they are drawn: one of its own, so that no other files are touched.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "process/results/storage/directory_lock.h"

namespace diefill::app {

/// Throws process::SceneError, in one line, where a file stands at `wanted`, or a folder with other files
/// than frames.
void require_frames_alone(const std::filesystem::path& wanted);

/// A new folder beside `wanted`, locked. With its files it is gone at the end of this object's life unless it
/// is kept; what a killed process has left of such folders is removed when the next is made.
class FrameFolder {
 public:
  /// Throws std::runtime_error where it cannot be made, results::ResultError where it cannot be locked.
  explicit FrameFolder(std::filesystem::path wanted);
  ~FrameFolder();
  FrameFolder(const FrameFolder&) = delete;
  FrameFolder& operator=(const FrameFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Gives it the wanted name. What has that name is renamed to <name>-previous-1 or the first free number,
  /// which `on_note` reports.
  void keep(const std::function<void(const std::string&)>& on_note);

 private:
  std::filesystem::path wanted_, path_;
  std::optional<results::DirectoryLock> lock_;  ///< until it is kept
};

}  // namespace diefill::app
