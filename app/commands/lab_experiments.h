// Experiments of the laboratory that run scenes, one `diefill lab NAME` each, and the page of all published
// figures.
#pragma once

#include <string>

#include "app/commands/commands.h"

namespace diefill::app {

/// Adds a command for each experiment, and `fidelity`, to `diefill lab`.
void add_lab_experiments(CLI::App& lab, Action& chosen);

/// One line for each experiment: name, number of published figures, question.
std::string list_of_experiments(const std::string& scenes);

}  // namespace diefill::app
