// The spheres that a block's pairs are between, copied side by side: what a contact needs lies together.
#pragma once

#include <algorithm>

#include "engine/pair_table.h"
#include "engine/sphere_field.h"

namespace diefill::engine {

/// Entry k belongs to local sphere k of the block last taken in.
struct LocalSpheres {
  std::vector<Vector3> position;  ///< m, centres
  std::vector<SphereMotion> motion;

  /// Takes in the block's own spheres and their partners as they are now.
  void take(const Block& block, const SphereField& spheres) {
    const std::size_t own = block.own_spheres(), all = own + block.partners.size();
    position.resize(std::max(position.size(), all));
    motion.resize(std::max(motion.size(), all));
    const auto first = static_cast<std::ptrdiff_t>(block.begin * block.spheres_per_grain);
    std::copy_n(spheres.position.begin() + first, own, position.begin());
    std::copy_n(spheres.motion.begin() + first, own, motion.begin());
    for (std::size_t k = own; k < all; ++k) {
      const std::uint32_t sphere = block.partners[k - own];
      position[k] = spheres.position[sphere];
      motion[k] = spheres.motion[sphere];
    }
  }
};

}  // namespace diefill::engine
