#include "process/tradeoff/knob_registry.h"

#include "process/input/nearest_key.h"
#include "process/scene/key_path.h"
#include "process/tradeoff/knobs/knobs.h"

namespace diefill::process {

const std::vector<Knob>& knob_registry() {
  static const std::vector<Knob> all = {
      grain_diameter_knob(),     time_step_knob(),    reduced_modulus_knob(),
      wall_sphere_radius_knob(), wall_spacing_knob(), powder_height_knob(),
      slice_length_knob(),       skin_knob(),         grain_model_knob(),
  };
  return all;
}

Knob key_path_knob(const std::string& path) {
  Knob knob;
  knob.name = knob.label = path;
  knob.sign = path.substr(path.rfind('.') + 1);
  knob.finer = Finer::as_listed;
  knob.words = {"true", "false"};
  knob.current = [path](const Scene& scene) {
    return value_at(scene.text, scene.file, path).value_or("not set");
  };
  knob.usual = [](const Scene&) { return std::vector<std::string>{}; };
  knob.changes = sets_key(path);
  return knob;
}

Knob knob_called(const std::string& name) {
  std::vector<std::string> names;
  for (const Knob& knob : knob_registry()) {
    if (knob.name == name) return knob;
    names.push_back(knob.name);
  }
  if (name.find('.') != std::string::npos && is_key_path(name)) return key_path_knob(name);
  std::string message = "--vary: found \"" + name + "\", which is not a knob; ";
  if (const auto meant = nearest_key(name, names)) {
    message += "did you mean \"" + *meant + "\"?";
  } else {
    message += "allowed: ";
    for (const auto& known : names) message += known + ", ";
    message += "or the path of a scene key, such as economy.sleep";
  }
  throw SceneError(message);
}

}  // namespace diefill::process
