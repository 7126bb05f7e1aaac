// Shell completion: commands, options, their choices, and files elsewhere.
#pragma once

#include <string>

#include "app/shell/command_tree.h"

namespace diefill::app {

/// A script for bash that defines and registers the completion of `diefill`.
std::string bash_completion(const CommandText& program);

/// A file _diefill for zsh, to be put in a folder of $fpath.
std::string zsh_completion(const CommandText& program);

}  // namespace diefill::app
