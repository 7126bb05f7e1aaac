// A setting (quick, working, reference) for all variants of a scene, so that they stay comparable.
#pragma once

#include <vector>

#include "process/scene/setting.h"
#include "process/scene/variants.h"

namespace diefill::process::plan {

/// The variants with the setting's numbers in place of their own (process/plan/setting.h). The effect of
/// grain size and wall spheres on a density must not be mistaken for that of a way of filling: all get the
/// finest grains and the closest wall spheres that the setting chooses for any of them; with `reference` each
/// keeps the powder's own grain size. Reads the tools. Throws SceneError where a scene and the setting are
/// incompatible.
std::vector<Variant> with_setting(std::vector<Variant> variants, Setting setting);

}  // namespace diefill::process::plan
