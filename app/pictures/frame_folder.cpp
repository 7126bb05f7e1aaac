#include "app/pictures/frame_folder.h"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <system_error>
#include <utility>

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
  std::string name = wanted_.string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make a folder of frames beside " + wanted_.string() + ": " +
                             std::generic_category().message(errno) + "; choose another film with --out");
  path_ = name;
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
  fs::rename(path_, wanted_);
  path_ = wanted_;
}

}  // namespace diefill::app
