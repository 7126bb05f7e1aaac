// Experiments of the laboratory that run scenes, one `diefill lab NAME` each, and the page of all published
// figures.
#pragma once

#include <filesystem>
#include <string>

#include "app/commands/commands.h"
#include "process/results/studies/experiment_result.h"

namespace diefill::app {

/// Adds a command for each experiment, and `fidelity`, to `diefill lab`.
void add_lab_experiments(CLI::App& lab, Action& chosen);

/// Prints and writes the published figures that an experiment of a family has, as <experiment>_figures.csv
/// and .json; nothing where it has none. Throws results::ResultError, and SceneError without the published
/// figures.
void write_figures(const std::filesystem::path& directory, const results::ExperimentResult& result);

/// One line for each experiment: name, number of published figures, question.
std::string list_of_experiments(const std::string& scenes);

}  // namespace diefill::app
