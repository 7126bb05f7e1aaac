// The contact laws of a scene: among grains, and of grains with each tool's surface, at the wanted grain
// size. What [contact] says, or Bierwisch's law of the powder, comes out in the same form.
#pragma once

#include <map>
#include <string>

#include "engine/coarse_graining/bierwisch.h"
#include "engine/coarse_graining/force_scaling.h"
#include "engine/laws/law_parameters.h"
#include "process/scene/scene.h"

namespace diefill::process {

/// Laws of the grain of mean mass.
struct SceneLaws {
  engine::laws::LawParameters grains;
  std::map<std::string, engine::laws::LawParameters> surfaces;  ///< by material_of() the tools; [walls] too
  engine::coarse_graining::ForceScaling scaling;  ///< of forces; none where parameters are scaled
};

/// The powder's own parameters at the wanted grain size, after coarse graining.
engine::coarse_graining::Material coarse_material(const PowderSpec& powder, CoarseGraining rule);
inline engine::coarse_graining::Material coarse_material(const Scene& scene) {
  return coarse_material(scene.powder, scene.coarse_graining);
}

/// The laws for steps of `time_step` (s), which some rolling laws depend on.
SceneLaws scene_laws(const Scene& scene, double time_step);

/// The law between grains of two powders at the size to which the pair's factor of coarse graining takes it.
engine::laws::LawParameters pair_law(const Scene& scene, const PowderPair& pair, double time_step);

}  // namespace diefill::process
