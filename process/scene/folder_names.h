// Folder names from names that people give: any printable text in, and out what every file system, shell and
// command line accepts and the program itself does not write.
#pragma once

#include <string>
#include <vector>

namespace diefill::process {

/// Folder names for these names, one each, made of a-z, A-Z, 0-9, '-', '.' and '_' alone. They differ from
/// each other by more than case, from all files and folders that the program writes into a directory of runs,
/// and do not begin with '-' or '.'. Where a name's own letters do not ensure this (too many, not ASCII, or
/// the folder of another name), a number derived from the whole name is appended. A name has the same folder
/// in every list without a similar name. Names must differ.
std::vector<std::string> folder_names(const std::vector<std::string>& names);

/// The folder of a name that stands alone.
std::string folder_of_name(const std::string& name);

}  // namespace diefill::process
