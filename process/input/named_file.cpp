#include "process/input/named_file.h"

#include <system_error>

#include "process/input/shown_value.h"

namespace diefill::process {

std::filesystem::path named_file(TableReader& table, const std::string& key, const std::string& example) {
  namespace fs = std::filesystem;
  constexpr std::size_t kLongest = 400;  // bytes of a path in a message
  const std::string name = table.required_text(key, example);
  const std::string allowed = "allowed: the path of a file, such as \"" + example + '"';
  if (name.empty()) table.reject(key, allowed);
  const fs::path file = table.file().parent_path() / name;
  std::error_code error;
  const auto status = fs::status(file, error);
  if (fs::is_directory(status)) table.reject(key, "which is a folder; " + allowed);
  if (status.type() == fs::file_type::not_found)
    table.reject(key, allowed + "; there is no " +
                          one_line(fs::absolute(file, error).lexically_normal().string(), kLongest));
  return file;
}

}  // namespace diefill::process
