// How to call this program, for the commands that it prints for the user.
#pragma once

#include <cerrno>
#include <string>

#include "process/input/shell_word.h"

namespace diefill::app {

/// The word that started the program, for a shell: "diefill" where that was found on the PATH, else its path.
inline std::string own_command() {
  return process::shell_word(program_invocation_name);
}

}  // namespace diefill::app
