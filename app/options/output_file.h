// Files that the user names for the program to write: refused, before work is lost, where they are something
// else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::app {

/// A file to be written, as an option names it.
struct OutputFile {
  std::string option;  ///< such as "--picture"
  std::filesystem::path file;
  std::vector<std::string> endings;  ///< allowed ones in small letters, such as ".png"
};

/// The ending of a file's name in small letters, such as ".inp" of PART.INP.
std::string ending_of(const std::filesystem::path& file);

/// Throws process::SceneError, in one line, where the file has another ending (capitals are taken) or too
/// long a name, is a directory, lies below a file, or is one of `inputs`, which the command reads: also by
/// another path or a link. Throws as require_writable() where no file can be made in its directory.
void require_output_file(const OutputFile& output, const std::vector<std::filesystem::path>& inputs);

/// Throws process::SceneError where one is an input or a directory, for files `names` that the command writes
/// into a directory of `option`.
void require_other_files(const std::string& option, const std::filesystem::path& directory,
                         const std::vector<std::string>& names,
                         const std::vector<std::filesystem::path>& inputs);

/// Makes the directory of a file that require_output_file() has accepted. Throws as make_output_directory().
void make_directory_of(const OutputFile& output);

}  // namespace diefill::app
