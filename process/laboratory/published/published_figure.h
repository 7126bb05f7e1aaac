// Published figures that experiments are compared with: numbers with the range that agrees with them, read
// from sample_tools/laboratory/published_figures.csv.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace diefill::process::laboratory {

struct PublishedFigure {
  std::string id;
  std::string source, section, place;  ///< "Bierwisch 2009", "section 4.1.5", "Table 4.4"
  std::string model, setting, quantity, unit;
  std::string published;        ///< number as printed, or "trend"
  double lower = 0, upper = 0;  ///< in `unit`, least and largest value that agree; NaN: none
  std::string kind;             ///< "value"; "trend": a number that shows it; "input": nothing to be met
  std::string experiment;       ///< of `diefill lab`; empty: none yet
};

/// All of a file, in its order. Throws SceneError, naming the line, for a file that is missing or wrong.
std::vector<PublishedFigure> read_published_figures(const std::filesystem::path& file);

/// Throws SceneError for the first of `ids` that `figures`, read from `file`, lack.
void require_figures(const std::vector<PublishedFigure>& figures, const std::vector<std::string>& ids,
                     const std::filesystem::path& file);

/// The figure of that id. Throws std::out_of_range where there is none.
const PublishedFigure& figure_called(const std::vector<PublishedFigure>& figures, const std::string& id);

}  // namespace diefill::process::laboratory
