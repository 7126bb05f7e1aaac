#include "process/compare/copied_files.h"

#include <utility>

#include "geometry/cad/mesh_import.h"
#include "geometry/cad/referred_files.h"
#include "process/compare/backups.h"
#include "process/results/storage/atomic_file.h"
#include "process/results/storage/file_contents.h"
#include "process/results/storage/result_file.h"
#include "process/scene/folder_names.h"

namespace diefill::process {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "tools";

std::string bytes_in(const fs::path& file) {
  auto bytes = results::contents_or_nothing(file);
  if (!bytes) throw results::ResultError("cannot copy " + file.string() + ": cannot read it");
  return std::move(*bytes);
}

/// Copies `file` as `copy` unless that is there already, byte for byte.
void copy_whole(const fs::path& file, const fs::path& copy) {
  const std::string bytes = bytes_in(file);
  if (fs::exists(copy) && bytes_in(copy) == bytes) return;
  make_folder(copy.parent_path());
  results::write_text_atomically(copy, bytes);
}

/// Of the copy, relative to the directory; a file with `company` has a folder of its own.
fs::path place_of(const fs::path& file, bool company) {
  const std::string name = folder_of_name(file.stem().string()) + '-' + geometry::file_hash(file);
  return company ? fs::path(kFolder) / name / file.filename()
                 : fs::path(kFolder) / (name + file.extension().string());
}

}  // namespace

CopiedFiles::CopiedFiles(const fs::path& directory) : directory_(directory) {
  make_folder(directory / kFolder);
}

std::string CopiedFiles::copy(const fs::path& file) {
  const auto known = copied_.find(file);
  if (known != copied_.end()) return known->second;
  const auto referred = geometry::referred_files(file);
  const fs::path target = place_of(file, !referred.empty());
  copy_whole(file, directory_ / target);
  for (const fs::path& other : referred)
    copy_whole(file.parent_path() / other, directory_ / target.parent_path() / other);
  return copied_[file] = target.generic_string();
}

std::string path_of_copy(const fs::path& file) {
  return place_of(file, !geometry::referred_files(file).empty()).generic_string();
}

}  // namespace diefill::process
