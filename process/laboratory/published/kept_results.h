// What experiments gave in earlier runs, kept in one CSV file beside the page of fidelity: a later run of
// some of them replaces its own rows only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "process/laboratory/published/published_figure.h"
#include "process/results/studies/lab_table.h"

namespace diefill::process::laboratory {

/// Name of the file.
inline constexpr const char* kKeptResults = "kept_results.csv";

struct KeptResult {
  std::string size;     ///< of the experiment, "coarse", "medium" or "published"
  results::LabRow row;  ///< with range and verdict of the figure as it is published at present
};

/// 0 of "coarse", 1 of "medium", 2 of "published". Throws SceneError that names `where` for another word.
std::size_t fineness_of(const std::string& size, const std::string& where = "size");

/// Whether a row of an experiment of that size takes the place of an earlier one: it has a value where the
/// earlier one has none, finer grains, or at the same size as many seeds at least.
bool replaces(const results::LabRow& row, const std::string& size, const results::LabRow& earlier,
              const std::string& earlier_size);

/// All of `file`; none where it is missing. Figures that are not published are left out. Throws SceneError,
/// naming the line, for a file that is wrong.
std::vector<KeptResult> read_kept_results(const std::filesystem::path& file,
                                          const std::vector<PublishedFigure>& figures);

/// Takes the figures of `measured` over as replaces() says, and the reason of a run that gave none where
/// there is no value yet. What is calculated without a bed, and runs that were never started, change nothing.
void take_over(std::vector<KeptResult>& kept, const std::vector<results::LabTable>& measured);

/// The file's text: id, size, values of the seeds in the unit of the figure, d in mm, core seconds, reason,
/// number of seeds.
std::string csv_of(const std::vector<KeptResult>& kept);

/// The tables of the page: kept ones, coarse ones first, with the names that `measured` of the same size has
/// for their quantities, then what `measured` has besides.
std::vector<results::LabTable> tables_with_kept(const std::vector<KeptResult>& kept,
                                                std::vector<results::LabTable> measured);

}  // namespace diefill::process::laboratory
