// The widest Gaussian that fields of a scene may be averaged with, which its cavity sets.
#pragma once

#include "process/tooling/tooling.h"

namespace diefill::process {

/// Throws SceneError where measure.averaging_width is larger than the largest edge of the cavity (where there
/// is none, of the box about tools and powder): the field would be the same everywhere. `tooling` has its
/// cavity.
void refuse_wide_averaging(const Scene& scene, const Tooling& tooling);

}  // namespace diefill::process
