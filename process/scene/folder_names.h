// Names that people give, as names of folders: any printable text on the one side, on the other what every
// file system, shell and command line takes, and nothing that the program writes itself.
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// Folder names for these names, one each, made of a-z, A-Z, 0-9, '-', '.' and '_' alone. They differ from
/// each other by more than capitals, from all files and folders that the program writes into a directory of
/// runs, and do not begin with '-' or '.'. Where a name's own letters do not see to that (they are too many,
/// no ASCII letters, or would give the folder of another name), a number made of the whole name stands
/// behind. A name has the same folder in every list in which no other comes close to it. Names must differ.
std::vector<std::string> folder_names(const std::vector<std::string>& names);

/// The folder of a name that stands alone.
std::string folder_of_name(const std::string& name);

}  // namespace diefill::process
