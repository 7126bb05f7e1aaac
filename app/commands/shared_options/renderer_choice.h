// --renderer of commands that draw shaded views.
#pragma once

#include <CLI/CLI.hpp>

namespace diefill::app {

/// Adds the option; what it names draws all shaded views of the program.
void add_renderer(CLI::App& command);

}  // namespace diefill::app
