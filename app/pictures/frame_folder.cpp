#include "app/pictures/frame_folder.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "process/compare/backups.h"
#include "process/input/scene_error.h"

namespace diefill::app {

namespace fs = std::filesystem;

namespace {

/// 00000.png and the like.
bool is_frame(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return entry.is_regular_file() && name.size() >= 9 && name.ends_with(".png") &&
         name.find_first_not_of("0123456789") == name.size() - 4;
}

constexpr std::string_view kEnding = ".XXXXXX";  // of the folder's name, for mkdtemp

/// Folders for frames of `wanted` whose process was killed while it drew.
void remove_left_folders(const fs::path& wanted) {
  const fs::path above = wanted.has_parent_path() ? wanted.parent_path() : fs::path(".");
  const std::string start = wanted.filename().string() + '.';
  std::vector<fs::path> left;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(above, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(start) && name.size() == start.size() - 1 + kEnding.size() &&
        entry.symlink_status(ignored).type() == fs::file_type::directory &&
        results::left_by_a_killed_process(entry.path()))
      left.push_back(entry.path());
  }
  for (const fs::path& folder : left) fs::remove_all(folder, ignored);
}

}  // namespace

void require_frames_alone(const fs::path& wanted) {
  std::error_code ignored;
  const auto type = fs::status(wanted, ignored).type();
  if (type == fs::file_type::not_found) return;
  const std::string found = "found \"" + wanted.string() + "\", where the frames are to be kept, ";
  if (type != fs::file_type::directory)
    throw process::SceneError("--out: " + found + "which is no folder; choose another film");
  for (const auto& entry : fs::directory_iterator(wanted, ignored))
    if (!is_frame(entry))
      throw process::SceneError("--out: " + found + "with other files than frames, such as \"" +
                                entry.path().filename().string() + "\"; choose another film, or move them");
}

FrameFolder::FrameFolder(fs::path wanted) : wanted_(std::move(wanted)) {
  remove_left_folders(wanted_);
  std::string name = wanted_.string() + std::string(kEnding);
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make a folder of frames beside " + wanted_.string() + ": " +
                             std::generic_category().message(errno) + "; choose another film with --out");
  path_ = name;
  try {
    lock_.emplace(path_);
  } catch (const results::ResultError&) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    throw;
  }
}

FrameFolder::~FrameFolder() {
  std::error_code ignored;
  if (path_ != wanted_) fs::remove_all(path_, ignored);
}

void FrameFolder::keep(const std::function<void(const std::string&)>& on_note) {
  if (fs::symlink_status(wanted_).type() != fs::file_type::not_found)
    on_note("note: " + wanted_.string() + " was there already and is now " +
            process::back_up(wanted_).string());
  fs::permissions(
      path_, fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read | fs::perms::others_exec,
      fs::perm_options::add);
  lock_.reset();
  fs::rename(path_, wanted_);
  path_ = wanted_;
}

}  // namespace diefill::app
