// The files that scenes need, copied beside the runs of a comparison so that these are self-contained.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace diefill::process {

/// Copies of CAD files and tables of motions in `tools` of a directory. They are named after their contents:
/// two files of one name do not clash, and a scene names another file as soon as the contents change. Files
/// that a CAD file refers to (geometry/cad/referred_files.h) go with it, in a folder of its own.
class CopiedFiles {
 public:
  /// Throws results::ResultError where `tools` cannot be made.
  explicit CopiedFiles(const std::filesystem::path& directory);

  /// Copies the file unless it is there; gives its path relative to `directory`. Throws results::ResultError.
  std::string copy(const std::filesystem::path& file);

 private:
  std::filesystem::path directory_;
  std::map<std::filesystem::path, std::string> copied_;
};

/// The path that `copy` gives, without copying. Throws results::ResultError where the file cannot be read.
std::string path_of_copy(const std::filesystem::path& file);

}  // namespace diefill::process
