// The commands of the program, one file each. To add one: a file with a function like these, its declaration
// here and its line in commands.cpp.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace diefill::app {

/// What to do once the command line has been read; returns the exit code.
using Action = std::function<int()>;

// Each adds its command to the program; `chosen` is set when the user asks for it.
void add_new(CLI::App& program, Action& chosen);
void add_run(CLI::App& program, Action& chosen);
void add_check(CLI::App& program, Action& chosen);
void add_estimate(CLI::App& program, Action& chosen);
void add_plan(CLI::App& program, Action& chosen);
void add_powders(CLI::App& program, Action& chosen);
void add_fit_discharge(CLI::App& program, Action& chosen);
void add_compare(CLI::App& program, Action& chosen);
void add_tradeoff(CLI::App& program, Action& chosen);
void add_calibrate(CLI::App& program, Action& chosen);
void add_map(CLI::App& program, Action& chosen);
void add_film(CLI::App& program, Action& chosen);
void add_report(CLI::App& program, Action& chosen);
void add_export(CLI::App& program, Action& chosen);
void add_info(CLI::App& program, Action& chosen);
void add_bench(CLI::App& program, Action& chosen);
void add_lab(CLI::App& program, Action& chosen);

/// Adds all commands.
void add_commands(CLI::App& program, Action& chosen);

}  // namespace diefill::app
