// Which terms of the force law a scene uses, and which are omitted because their coefficients are zero.
#pragma once

#include <string>
#include <vector>

#include "process/scene/scene.h"

namespace diefill::engine {
struct SimulationSettings;
}  // namespace diefill::engine

namespace diefill::process {

/// Names of terms.
struct LawTerms {
  std::vector<std::string> used, left_out;
};

/// The terms of a scene with these settings (of engine_settings()).
LawTerms law_terms(const Scene& scene, const engine::SimulationSettings& settings);

/// "a, b, c"; "none".
std::string joined(const std::vector<std::string>& names);

}  // namespace diefill::process
