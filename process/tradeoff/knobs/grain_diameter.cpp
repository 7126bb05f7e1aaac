#include "process/tradeoff/knobs/knobs.h"

namespace diefill::process {
namespace {

constexpr std::string_view kBy = " by ";

/// "1.88 mm" of "1.88 mm by bierwisch".
std::string diameter_in(const std::string& value) {
  return value.substr(0, value.find(kBy));
}

SceneChanges changes(const Scene&, const std::string& value) {
  SceneChanges changes{"powder.grain_diameter = " + toml_value(diameter_in(value)) + '\n', {}};
  const std::size_t by = value.find(kBy);
  if (by != std::string::npos)
    changes.set += "powder.coarse_graining = " + toml_value(value.substr(by + kBy.size())) + '\n';
  return changes;
}

/// Work goes with d^-4: half as coarse again costs a fifth, 0.7 d four times as much.
std::vector<std::string> usual(const Scene& scene) {
  std::vector<std::string> values;
  for (const double factor : {2.0, 1.5, 0.7})
    values.push_back(in_millimetres(factor * scene.powder.grain_diameter));
  return values;
}

}  // namespace

Knob grain_diameter_knob() {
  return {.name = "grain_diameter",
          .label = "model grain diameter d",
          .sign = "d",
          .finer = Finer::smaller,
          .dimension = Dimension::length,
          .current = [](const Scene& scene) { return in_millimetres(scene.powder.grain_diameter); },
          .usual = usual,
          .changes = changes};
}

}  // namespace diefill::process
