// What one worker needs while it computes a block of grains in a step.
#pragma once

#include "engine/contact/contact_workspace.h"
#include "engine/contact/local_spheres.h"
#include "engine/search/contact_sums.h"

namespace diefill::engine {

/// Memory of one worker, used again block after block: it grows to what the largest block needs.
struct BlockWorkspace {
  LocalSpheres spheres;
  ContactWorkspace contact;
  ContactSums gathered;  ///< where the block's own sums are still needed
};

}  // namespace diefill::engine
