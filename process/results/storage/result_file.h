// Stores a FillResult as one HDF5 file that explains itself, beside an XDMF file for ParaView and
// report.json. The schema is documented in process/results/README.md.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "process/results/fill_result.h"

namespace diefill::results {

/// A results file that is missing, damaged or of another version. The message is one line for people.
struct ResultError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes `directory`/results.h5 and results.xdmf, each whole or not at all (temporary file, fsync, rename).
/// Throws ResultError when the disk is full or not writable; what was there before then still stands.
void write_results(const std::filesystem::path& directory, const FillResult& result);

/// Reads `directory`/results.h5. Throws ResultError naming the file and what is wrong with it.
FillResult read_results(const std::filesystem::path& directory);

/// Writes `directory`/report.json whole or not at all. Throws ResultError as above.
void write_report(const std::filesystem::path& directory, const FillResult& result);

}  // namespace diefill::results
