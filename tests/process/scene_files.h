// A folder for the time of a test, with the files that a test scene names.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace diefill::process {

/// Makes the folder with empty `die.stl`, `shoe.stl`, `part.step` and a folder `parts`; removes it at the
/// end.
class SceneFolder {
 public:
  SceneFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "diefill_scene_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no folder for the test could be made");
    path_ = pattern;
    for (const char* name : {"die.stl", "shoe.stl", "part.step"}) std::ofstream(path_ / name) << "";
    std::filesystem::create_directory(path_ / "parts");
  }
  ~SceneFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Writes `text` to scene.toml, byte by byte, and gives its path.
  std::filesystem::path write(const std::string& text) const {
    const std::filesystem::path file = path_ / "scene.toml";
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace diefill::process
