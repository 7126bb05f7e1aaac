#include "engine/state.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace diefill::engine {

namespace {

class Fnv1a {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < bytes; ++k) value_ = (value_ ^ byte[k]) * 0x100000001b3ULL;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::uint64_t state_hash(std::uint64_t step, const Grains& grains) {
  std::vector<std::size_t> order(grains.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return grains.id[a] < grains.id[b]; });
  Fnv1a hash;
  hash.add(&step, sizeof step);
  for (const std::size_t k : order) {
    hash.add(&grains.id[k], sizeof grains.id[k]);
    const std::uint16_t kind = grains.kind_of(k);
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
