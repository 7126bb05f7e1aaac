#include "process/tradeoff/parameter_registry.h"

#include "process/input/nearest_key.h"
#include "process/scene/key_path.h"
#include "process/tradeoff/parameters/parameters.h"

namespace diefill::process {

const std::vector<Parameter>& parameter_registry() {
  static const std::vector<Parameter> all = {
      grain_diameter_parameter(),     time_step_parameter(),    reduced_modulus_parameter(),
      wall_sphere_radius_parameter(), wall_spacing_parameter(), powder_height_parameter(),
      slice_length_parameter(),       skin_parameter(),         grain_model_parameter(),
  };
  return all;
}

Parameter key_path_parameter(const std::string& path) {
  Parameter parameter;
  parameter.name = parameter.label = path;
  parameter.sign = path.substr(path.rfind('.') + 1);
  parameter.finer = Finer::as_listed;
  parameter.words = {"true", "false"};
  parameter.current = [path](const Scene& scene) {
    return value_at(scene.text, scene.file, path).value_or("not set");
  };
  parameter.usual = [](const Scene&) { return std::vector<std::string>{}; };
  parameter.changes = sets_key(path);
  return parameter;
}

Parameter parameter_called(const std::string& name) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameter_registry()) {
    if (parameter.name == name) return parameter;
    names.push_back(parameter.name);
  }
  if (name.find('.') != std::string::npos && is_key_path(name)) return key_path_parameter(name);
  std::string message = "--vary: found \"" + name + "\", which is not a parameter; ";
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
