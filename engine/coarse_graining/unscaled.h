// No coarse graining: large grains under the law of small ones as it stands.
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// Whatever the size of the grains, forces are those of the law at that size.
inline ForceScaling unscaled() {
  return {};
}

}  // namespace diefill::engine::coarse_graining
