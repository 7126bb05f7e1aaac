// Experiments of the laboratory that run scenes, one `diefill lab NAME` each, and the page of all published
// figures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "process/laboratory/published/published_figure.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::app {

/// Adds a command for each experiment, and `fidelity`, to `diefill lab`.
void add_lab_experiments(CLI::App& lab, Action& chosen);

using PublishedFigures = std::vector<process::laboratory::PublishedFigure>;

/// The published figures in the folder `scenes`; where that is empty, in the one that comes with the program.
/// Throws SceneError where there are none, or one of `ids` is missing.
PublishedFigures published_figures_in(const std::string& scenes, const std::vector<std::string>& ids = {});

/// Prints and writes what an experiment of a family has of published figures, as <experiment>_figures.csv
/// and .json; nothing where it has none. Throws results::ResultError.
void write_figures(const std::filesystem::path& directory, const results::ExperimentResult& result,
                   const PublishedFigures& published);

/// One line for each experiment: name, number of published figures, question.
std::string list_of_experiments(const std::string& scenes);

}  // namespace diefill::app
