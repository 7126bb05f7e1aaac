// Whether a scene's powder is one of the published ones, as what was measured with that may be told of it.
#pragma once

#include "process/scene/scene.h"

namespace diefill::process {

/// Whether a powder is the preset of its name with the published parameters. Grain size and apparent density
/// may differ: the one is a matter of coarse graining, the other of weighing.
bool is_unchanged_preset(const PowderSpec& powder);

/// The scene's powder; without the name of a preset where powder or scene change what acts on its grains: its
/// parameters, [contact], gravity, or a step that does so.
PowderSpec powder_as_published(const Scene& scene);

}  // namespace diefill::process
