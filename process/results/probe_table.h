// Probes as CSV files, for spreadsheets.
#pragma once

#include <filesystem>
#include <string>

#include "process/results/fill_result.h"

namespace diefill::results {

/// One line of headings with units, then a line a row, in as many digits as give the same number back.
std::string probe_table(const ProbeSeries& probe);

/// Writes `directory`/probe_<name>.csv for every probe, each whole or not at all. Throws ResultError.
void write_probe_tables(const std::filesystem::path& directory, const FillResult& result);

}  // namespace diefill::results
