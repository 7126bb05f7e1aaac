// The command that makes films.
#pragma once

#include "app/commands/commands.h"

namespace diefill::app {

void add_film(CLI::App& program, Action& chosen);

}  // namespace diefill::app
