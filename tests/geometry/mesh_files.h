// Writes meshes to CAD files for tests, in a temporary directory of the test's own.
#pragma once

#include <filesystem>
#include <string>

#include "geometry/mesh.h"

namespace diefill::geometry::sample {

/// A directory that is made for one test and removed with all its files when it goes.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  /// Writes `bytes` to a file `name` and returns its path.
  std::filesystem::path write(const std::string& name, const std::string& bytes) const;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The bytes of a file of each format; coordinates are written as they are.
std::string ascii_stl(const Mesh& mesh);
std::string binary_stl(const Mesh& mesh);
std::string obj(const Mesh& mesh);
std::string ply(const Mesh& mesh);

}  // namespace diefill::geometry::sample
