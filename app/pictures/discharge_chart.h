// The chart of a fitted discharge law: measurements as points, the law as a line in its band of uncertainty.
#pragma once

#include <filesystem>

#include "process/continuum/discharge_fit.h"

namespace diefill::app {

/// Draws the PNG. Throws what render::draw_chart() throws.
void draw_discharge(const std::filesystem::path& png, const process::continuum::DischargeFit& fit,
                    const process::continuum::DischargeData& data);

}  // namespace diefill::app
