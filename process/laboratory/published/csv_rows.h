// Rows of the laboratory's CSV files, with messages that name file and line.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace diefill::process::laboratory {

/// What a file that cannot be read means.
enum class MissingFile {
  no_rows,  ///< the same as a file without rows
  error,    ///< SceneError: it belongs to the laboratory's scenes
};

/// Calls `use` with the fields of each row below the heading; `where` is "file:line", for messages. Throws
/// SceneError for a row with another number of fields; the last `optional` ones may be missing.
void for_each_row(
    const std::filesystem::path& file, std::size_t columns, MissingFile missing,
    const std::function<void(const std::vector<std::string>& fields, const std::string& where)>& use,
    std::size_t optional = 0);

/// The number that `field` is. Throws SceneError for anything else.
double number_in(const std::string& field, const std::string& where);

/// The same; NaN for an empty field.
double number_or_nothing_in(const std::string& field, const std::string& where);

/// The numbers of a field, with blanks between; and such a field.
std::vector<double> numbers_in(const std::string& field, const std::string& where);
std::string text_of(const std::vector<double>& numbers);

}  // namespace diefill::process::laboratory
