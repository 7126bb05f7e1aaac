// Files packed in a ZIP archive, as 3MF always is and AMF may be.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace diefill::geometry {

/// Whether a file of these bytes is one.
bool is_zip_archive(std::string_view bytes);

/// A file of an archive.
struct UnpackedFile {
  std::string text;
  bool is_whole = false;  ///< false: damaged, or packed in a way that is not read
};

/// Calls `look(file)` for every file of `archive` whose name ends in `ending` (lower case; names may be in
/// capitals), until it returns false. Does nothing where `archive` is no archive. Throws std::runtime_error
/// where a file takes more than 1 GiB.
void visit_archive(const std::filesystem::path& archive, std::string_view ending,
                   const std::function<bool(UnpackedFile)>& look);

}  // namespace diefill::geometry
