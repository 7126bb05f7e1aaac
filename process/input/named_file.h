// A file that a key of a TOML file names, found before it is read: messages name the key and its line.
#pragma once

#include <filesystem>
#include <string>

#include "process/input/table_reader.h"

namespace diefill::process {

/// The path under `key`, relative to the folder of the table's file. Throws SceneError at the key where it is
/// missing, empty, or names no file or a folder.
std::filesystem::path named_file(TableReader& table, const std::string& key, const std::string& example);

}  // namespace diefill::process
