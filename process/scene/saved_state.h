// Powder that begins as another run left it (pour.state), in place of the lattice.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>

#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// The grains of that run's end below the cut; the text of its scene and its tools are ignored. Throws
/// results::ResultError where the directory has no results or they are damaged.
results::PowderState powder_of(const SavedState& state);

}  // namespace diefill::process
