// Documents as the tests of them read them: what stands between backquotes, in tables and in blocks of code.
#pragma once

#include <functional>
#include <regex>
#include <string>
#include <vector>

namespace diefill::project {

/// All documents of the project, relative to its root.
std::vector<std::string> documents();

/// Calls use(document, first group) for every match in every document.
void for_each_match(const std::regex& pattern,
                    const std::function<void(const std::string&, const std::string&)>& use);

/// The texts between single backquotes on a line.
std::vector<std::string> quoted_code(const std::string& line);

/// First cells of the rows of tables whose heading begins with a word for files: "file", "folder".
std::vector<std::string> file_cells(const std::string& text);

/// Lines of all blocks of code of a language, such as "toml".
std::vector<std::string> code_lines(const std::string& text, const std::string& language);

/// Folder of a document, with a slash at its end; empty for the root.
std::string folder_of(const std::string& document);

}  // namespace diefill::project
