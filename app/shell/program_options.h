// Options of the program that belong to no command: they print a text and end the program.
#pragma once

#include <CLI/CLI.hpp>

namespace diefill::app {

/// Adds --version, --completion and --man.
void add_program_options(CLI::App& program);

}  // namespace diefill::app
