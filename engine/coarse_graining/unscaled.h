// No coarse graining: large grains under the unchanged law of small ones.
#pragma once

#include "engine/coarse_graining/force_scaling.h"

namespace diefill::engine::coarse_graining {

/// Forces are those of the law at the size of the grains.
inline ForceScaling unscaled() {
  return {};
}

}  // namespace diefill::engine::coarse_graining
