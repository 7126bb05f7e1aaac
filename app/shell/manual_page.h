// The manual page of the program.
#pragma once

#include <string>

#include "app/shell/command_tree.h"

namespace diefill::app {

/// diefill(1) in the man macros of roff: every command with its options, exit codes, environment and
/// examples. `version` stands at its foot.
std::string manual_page(const CommandText& program, const std::string& version);

}  // namespace diefill::app
