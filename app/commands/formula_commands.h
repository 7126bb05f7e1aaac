// Commands that compute by formula, without grains.
#pragma once

#include "app/commands/commands.h"

namespace diefill::app {

void add_estimate(CLI::App& program, Action& chosen);
void add_fit_discharge(CLI::App& program, Action& chosen);

}  // namespace diefill::app
