// Settings and figures of sawing's runs as JSON, as their result files keep them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "process/laboratory/published/sawing/groove.h"
#include "process/laboratory/published/sawing/viscosity.h"

namespace diefill::process::laboratory::sawing {

/// Law and time step of a fluid, and the slurry's constants. Figures of runs under other settings are others.
nlohmann::ordered_json fluid_settings(const engine::FluidSettings& fluid);

std::string text_of(const ShearedFigures& figures);
std::string text_of(const GrooveFigures& figures);

/// Figures of such a text. Throw nlohmann::json::exception for another one.
ShearedFigures sheared_figures(const std::string& text);
GrooveFigures groove_figures(const std::string& text);

}  // namespace diefill::process::laboratory::sawing
