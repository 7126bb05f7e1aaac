#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {
namespace {

constexpr std::string_view kBy = " by ";

/// "1.88 mm" of "1.88 mm by bierwisch".
std::string diameter_in(const std::string& value) {
  return value.substr(0, value.find(kBy));
}

/// Of grains of several sizes that of mean mass: all are enlarged with it.
std::string key_of(const Scene& scene) {
  return scene.powder.sizes.empty() ? "powder.grain_diameter" : "powder.sizes.mean_size";
}

SceneChanges changes(const Scene& scene, const std::string& value) {
  SceneChanges changes{key_of(scene) + " = " + toml_value(diameter_in(value)) + '\n', {}};
  const std::size_t by = value.find(kBy);
  if (by != std::string::npos)
    changes.set += "powder.coarse_graining = " + toml_value(value.substr(by + kBy.size())) + '\n';
  return changes;
}

/// As the scene writes it: presets of model D take the rounded 0.47 mm for their exact 0.4704 mm, and so its
/// multiples.
std::string current(const Scene& scene) {
  return value_at(scene.text, scene.file, key_of(scene))
      .value_or(in_millimetres(scene.powder.grain_diameter));
}

/// Work goes with d^-4: half as coarse again costs a fifth, 0.7 d four times as much.
std::vector<std::string> usual(const Scene& scene) {
  const double now = parse_quantity(current(scene), Dimension::length);
  return {in_millimetres(2 * now), in_millimetres(1.5 * now), in_millimetres(0.7 * now)};
}

}  // namespace

Parameter grain_diameter_parameter() {
  return {.name = "grain_diameter",
          .label = "model grain diameter d",
          .sign = "d",
          .finer = Finer::smaller,
          .dimension = Dimension::length,
          .current = current,
          .usual = usual,
          .changes = changes};
}

}  // namespace diefill::process
