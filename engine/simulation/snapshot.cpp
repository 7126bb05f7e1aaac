#include "engine/simulation/snapshot.h"

#include <algorithm>
#include <numeric>

#include "engine/numerics/fnv1a.h"

namespace diefill::engine {

std::uint64_t state_hash(std::uint64_t step, const Grains& grains) {
  std::vector<std::size_t> order(grains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return grains.id[a] < grains.id[b]; });
  Fnv1a hash;
  hash.add(&step, sizeof step);
  for (const std::size_t k : order) {
    hash.add(&grains.id[k], sizeof grains.id[k]);
    const std::uint16_t kind = grains.type_of(k);
    if (kind != 0) hash.add(&kind, sizeof kind);
    hash.add(grains.position[k].data(), 3 * sizeof(double));
    const Quaternion orientation = grains.orientation_of(k);
    hash.add(orientation.data(), 4 * sizeof(double));
    hash.add(grains.velocity[k].data(), 3 * sizeof(double));
    hash.add(grains.spin[k].data(), 3 * sizeof(double));
  }
  return hash.value();
}

}  // namespace diefill::engine
