// Which files a run has read besides its scene and CAD, kept with its results and beside its checkpoint:
// later the same names may hold something else.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process/results/fill_result.h"
#include "process/scene/identity.h"

namespace diefill::process {

/// Keeps them with the results.
void add_input_files(const std::vector<InputFile>& files, results::FillResult& result);

/// Those that results were computed from; nothing for results of versions that did not keep them.
std::optional<std::vector<InputFile>> recorded_input_files(const results::FillResult& result);

/// The file beside the checkpoint in a results directory.
std::filesystem::path input_record_file(const std::filesystem::path& directory);

/// Writes that file; none where the scene refers to no files. Throws results::ResultError when the disk is
/// full.
void write_input_record(const std::filesystem::path& directory, const std::vector<InputFile>& files);

/// What that file holds; nothing where there is none.
std::optional<std::vector<InputFile>> read_input_record(const std::filesystem::path& directory);

/// What the run in a results directory has read, by its record or else by its results; nothing where neither
/// can be read.
std::optional<std::vector<InputFile>> input_files_read_in(const std::filesystem::path& directory);

/// The name of the first of `files` whose contents are not those of `then`, which has the same files in the
/// same order; nothing where all are.
std::optional<std::string> changed_file(const std::vector<InputFile>& files,
                                        const std::vector<InputFile>& then);

}  // namespace diefill::process
