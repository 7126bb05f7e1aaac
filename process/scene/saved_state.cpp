#include "process/scene/saved_state.h"

#include <toml++/toml.h>

#include "process/input/units.h"
#include "process/results/storage/result_file.h"
#include "process/scene/scene_text.h"

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

std::optional<SavedState> saved_state_of(const Scene& scene) {
  constexpr const char* kKey = "state";
  if (scene.text.find(kKey) == std::string::npos) return std::nullopt;  // most scenes; saves parsing
  const toml::table document = parse_scene_text(scene.text, scene.file);
  const auto name = document["pour"][kKey].value<std::string>();
  if (!name) return std::nullopt;
  SavedState state;
  state.directory = scene.file.parent_path() / *name;
  if (const auto below = document["pour"]["state_below"].value<std::string>())
    state.below = parse_quantity(*below, Dimension::length);
  return state;
}

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
