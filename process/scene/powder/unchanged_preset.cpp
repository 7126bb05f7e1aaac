#include "process/scene/powder/unchanged_preset.h"

#include <algorithm>
#include <array>

#include "process/machine/actions/powder_change.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::process {

namespace {

bool changes_what_acts(const Scene& scene) {
  constexpr double kSameGravity = 0.02;  // m/s^2; values in use differ by no more
  if (scene.contact || (scene.gravity - Scene{}.gravity).norm() > kSameGravity) return true;
  return std::any_of(scene.steps.begin(), scene.steps.end(), [](const auto& step) {
    const PowderChange* change = step->change();
    return change != nullptr && (change->changes_laws() || change->gravity);
  });
}

}  // namespace

bool is_unchanged_preset(const PowderSpec& powder) {
  const auto names = preset_names();
  if (powder.clump || std::find(names.begin(), names.end(), powder.name) == names.end()) return false;
  const PowderSpec published = powder_preset(powder.name);
  const auto numbers = [](const PowderSpec& spec) {
    return std::array{spec.sphere_radius,          spec.grain_mass,      spec.reduced_modulus,
                      spec.damping_over_radius,    spec.friction,        spec.work_of_adhesion,
                      spec.tangential_over_radius, spec.rolling_friction};
  };
  return powder.model == published.model && numbers(powder) == numbers(published);
}

PowderSpec powder_as_published(const Scene& scene) {
  PowderSpec powder = scene.powder;
  if (!is_unchanged_preset(powder) || changes_what_acts(scene)) powder.name = "custom";
  return powder;
}

}  // namespace diefill::process
