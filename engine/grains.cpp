#include "engine/grains.h"

namespace diefill::engine {

namespace {

template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
  std::vector<Value> sorted(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
  values.swap(sorted);
}

/// Calls `action` with every array of `grains`.
template <class Action>
void for_each_array(Grains& grains, const Action& action) {
  action(grains.id);
  action(grains.kind);
  action(grains.position);
  action(grains.velocity);
  action(grains.orientation);
  action(grains.spin);
  action(grains.force);
  action(grains.torque);
}

}  // namespace

void Grains::resize(std::size_t count) {
  for_each_array(*this, [count](auto& values) { values.resize(count); });
}

void Grains::reorder(const std::vector<std::uint32_t>& order) {
  for_each_array(*this, [&order](auto& values) { permute(values, order); });
}

}  // namespace diefill::engine
