// Figures that no result of a scene can have, such as the harmonics over the azimuth of a die that is no
// ring: a calibration to one of them would find nothing after hours of runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::process::calibration {

/// Why the powder of the scene gives no value of the figure, such as a mixing index of grains of one size,
/// and what to do; nothing where it may. `figure` is a name of results/figure_table.h.
std::optional<std::string> why_powder_has_no(const Scene& scene, const std::string& figure);

/// Whether the figure depends on the shape of the cavity, or needs one although no tool is a die.
bool depends_on_cavity(const Scene& scene, const std::string& figure);

/// Why a cavity of the scene has no value of the figure, and what to do; nothing where it may. `rings`:
/// whether each cavity is a ring, the largest first; empty where none is known before a run, in which a die
/// may still get one.
std::optional<std::string> why_cavity_has_no(const Scene& scene, const std::string& figure,
                                             std::size_t cavity, const std::vector<bool>& rings);

}  // namespace diefill::process::calibration
