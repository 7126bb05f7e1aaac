#include "engine/powder/grains.h"

namespace diefill::engine {

namespace {

template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
  std::vector<Value> sorted(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
  values.swap(sorted);
}

/// Calls `action` with every array of `grains` that all powders have.
template <class Action>
void for_each_array(Grains& grains, const Action& action) {
  action(grains.id);
  action(grains.position);
  action(grains.velocity);
  action(grains.spin);
  action(grains.force);
  action(grains.torque);
}

}  // namespace

void Grains::resize(std::size_t count, bool clumps, bool mixed) {
  for_each_array(*this, [count](auto& values) { values.resize(count); });
  if (clumps) orientation.resize(count);
  if (mixed) kind.resize(count);
}

void Grains::reorder(const std::vector<std::uint32_t>& order) {
  for_each_array(*this, [&order](auto& values) { permute(values, order); });
  if (!orientation.empty()) permute(orientation, order);
  if (!kind.empty()) permute(kind, order);
}

std::vector<Quaternion> Grains::orientations() const {
  return orientation.empty() ? std::vector<Quaternion>(size(), Quaternion(1, 0, 0, 0)) : orientation;
}

}  // namespace diefill::engine
