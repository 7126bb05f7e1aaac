#include "process/scene/saved_state.h"

#include "process/results/storage/result_file.h"

namespace diefill::process {
namespace {

/// Leaves grain k out of an array over grains that may be empty.
template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::size_t>& places) {
  if (values.empty()) return;
  std::vector<Value> kept;
  kept.reserve(places.size());
  for (const std::size_t k : places) kept.push_back(values[k]);
  values = std::move(kept);
}

}  // namespace

results::PowderState powder_of(const SavedState& state) {
  results::PowderState powder = results::read_results(state.directory).powder;
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < powder.position.size(); ++k)
    if (powder.position[k][2] <= state.below) places.push_back(k);
  keep(powder.id, places);
  keep(powder.position, places);
  keep(powder.orientation, places);
  keep(powder.velocity, places);
  keep(powder.angular_velocity, places);
  keep(powder.kind, places);
  return powder;
}

}  // namespace diefill::process
