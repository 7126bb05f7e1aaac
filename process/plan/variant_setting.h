// A setting (quick, working, reference) for all variants of a scene, so that they stay comparable.
#pragma once

#include <vector>

#include "process/scene/setting.h"
#include "process/scene/variants.h"

namespace diefill::process::plan {

/// The variants with the setting's numbers in place of their own (process/plan/setting.h). What grain size
/// and wall spheres do to a density must not pass for what a way of filling does: all get the finest grains
/// and the closest wall spheres that the setting chooses for any of them; with `reference` each keeps the
/// powder's own grain size. Reads the tools. Throws SceneError where a scene and the setting do not go
/// together.
std::vector<Variant> with_setting(std::vector<Variant> variants, Setting setting);

}  // namespace diefill::process::plan
