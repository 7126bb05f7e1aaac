#include "tests/project/document_text.h"

#include "tests/project/source_files.h"

namespace diefill::project {

std::vector<std::string> documents() {
  std::vector<std::string> found;
  for (const auto& file : written_files())
    if (file.ends_with(".md")) found.push_back(file);
  return found;
}

void for_each_match(const std::regex& pattern,
                    const std::function<void(const std::string&, const std::string&)>& use) {
  for (const auto& file : documents()) {
    const std::string text = text_of(file);
    for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
      use(file, (*match)[1].str());
  }
}

std::vector<std::string> quoted_code(const std::string& line) {
  static const std::regex quoted("`([^`]+)`");
  std::vector<std::string> found;
  for (std::sregex_iterator match(line.begin(), line.end(), quoted), end; match != end; ++match)
    found.push_back((*match)[1].str());
  return found;
}

std::vector<std::string> file_cells(const std::string& text) {
  static const std::regex heading(R"(\| *(file|folder)\b.*)"), cell(R"(\|([^|]*)\|.*)");
  std::vector<std::string> cells;
  bool in_table = false;
  for (const auto& line : lines_of(text)) {
    std::smatch part;
    if (std::regex_match(line, heading)) {
      in_table = true;
    } else if (!line.starts_with("|")) {
      in_table = false;
    } else if (in_table && std::regex_match(line, part, cell)) {
      cells.push_back(part[1]);
    }
  }
  return cells;
}

std::vector<std::string> code_lines(const std::string& text, const std::string& language) {
  std::vector<std::string> found;
  bool inside = false;
  for (const auto& line : lines_of(text)) {
    const std::size_t at = line.find_first_not_of(' ');
    const bool fence = at != std::string::npos && line.compare(at, 3, "```") == 0;
    if (fence)
      inside = !inside && line.substr(at) == "```" + language;
    else if (inside)
      found.push_back(line);
  }
  return found;
}

std::string folder_of(const std::string& document) {
  const std::size_t slash = document.rfind('/');
  return slash == std::string::npos ? "" : document.substr(0, slash + 1);
}

}  // namespace diefill::project
