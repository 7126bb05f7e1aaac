// One of several names on the command line: the message names the nearest.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace diefill::app {

/// What is said of a name that is none of `names`: what was found, the nearest, all that are allowed.
std::string unknown_name(const std::string& found, const std::vector<std::string>& names);

/// For options that hold one of `names`; help, completion and manual page list them.
CLI::Validator one_of(const std::vector<std::string>& names);

}  // namespace diefill::app
