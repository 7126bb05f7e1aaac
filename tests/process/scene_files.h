// A folder for the time of a test, with the files that a test scene names.
#pragma once

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace diefill::process {

/// A folder with empty `die.stl`, `shoe.stl`, `part.step`, `part.sldprt` and a folder `parts`.
class SceneFolder {
 public:
  SceneFolder() {
    for (const char* name : {"die.stl", "shoe.stl", "part.step", "part.sldprt"}) folder_.write(name, "");
    std::filesystem::create_directory(path() / "parts");
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  /// Writes `text` to scene.toml, byte by byte, and gives its path.
  std::filesystem::path write(const std::string& text) const { return folder_.write("scene.toml", text); }

 private:
  support::TemporaryFolder folder_;
};

}  // namespace diefill::process
