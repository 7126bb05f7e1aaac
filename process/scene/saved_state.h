// Powder that begins as another run left it (pour.state), in place of the lattice.
#pragma once

#include <filesystem>
#include <limits>
#include <optional>

#include "process/results/fill_result.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Where a scene's powder comes from.
struct SavedState {
  std::filesystem::path directory;                         ///< of the other run's results
  double below = std::numeric_limits<double>::infinity();  ///< m, grains with their centre above are left out
};

/// Nothing for a scene that pours. Copies of a scene do not carry the grains: those who need them read them.
std::optional<SavedState> saved_state_of(const Scene& scene);

/// The grains of that run's end below the cut; the text of its scene and its tools are left aside. Throws
/// results::ResultError where the directory has no results or they are damaged.
results::PowderState powder_of(const SavedState& state);

}  // namespace diefill::process
