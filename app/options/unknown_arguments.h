// Commands, experiments and options that do not exist: the message names the nearest that does.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace diefill::app {

/// A message about the first argument that `program` has read and does not recognise; nothing where it
/// recognises all. Names the command, such as "diefill lab".
std::optional<std::string> unknown_argument(const CLI::App& program);

}  // namespace diefill::app
