// Commands, experiments and options that do not exist: the message names the nearest that does.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace diefill::app {

/// What is wrong with the first word that `program` has read and knows no use for; nothing where it knows all
/// of them. Names the command, such as "diefill lab".
std::optional<std::string> unknown_argument(const CLI::App& program);

}  // namespace diefill::app
