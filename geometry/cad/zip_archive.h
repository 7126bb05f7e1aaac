// Files packed in a ZIP archive, as 3MF always is and AMF may be.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace diefill::geometry {

/// Whether a file of these bytes is one.
bool is_zip_archive(std::string_view bytes);

/// Calls `look(text)` for every file of `archive` whose name ends in `ending` (lower case; names may be in
/// capitals), unpacked, until it returns false. Does nothing where `archive` is no archive. Throws
/// std::runtime_error where a file is damaged or takes more than 1 GiB.
void visit_archive(const std::filesystem::path& archive, std::string_view ending,
                   const std::function<bool(std::string)>& look);

}  // namespace diefill::geometry
