#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/exit_code.h"
#include "app/tables/json_text.h"
#include "process/results/rounding.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/powder/powder_presets.h"

namespace diefill::app {

namespace {

nlohmann::ordered_json as_json(const process::PresetUse& preset) {
  const auto powder = process::powder_preset(preset.name);
  nlohmann::ordered_json json = {{"name", preset.name},
                                 {"use", preset.use},
                                 {"limits", preset.limits},
                                 {"fitted_to", preset.fitted_to},
                                 {"model", process::name_of(powder.model)},
                                 {"grain_diameter_m", powder.grain_diameter},
                                 {"friction", powder.friction},
                                 {"work_of_adhesion_J_m2", powder.work_of_adhesion},
                                 {"rolling_friction_m", powder.rolling_friction},
                                 {"apparent_density_kg_m3", nullptr},
                                 {"fills_dies", process::preset_warning(powder).empty()}};
  if (powder.apparent_density > 0) json["apparent_density_kg_m3"] = powder.apparent_density;
  return json;
}

void print(const process::PresetUse& preset) {
  const auto powder = process::powder_preset(preset.name);
  const std::string density =
      powder.apparent_density > 0
          ? results::in_significant_digits(1e-3 * powder.apparent_density, 3) + " g/cm3"
          : "unknown, estimated by runs";
  std::printf(
      "%s\n  use: %s\n  limits: %s\n  fitted to: %s; grain model %s of %.3g mm, apparent density %s\n",
      preset.name.c_str(), preset.use.c_str(), preset.limits.c_str(), preset.fitted_to.c_str(),
      process::name_of(powder.model), 1e3 * powder.grain_diameter, density.c_str());
}

int powders(bool json) {
  if (json) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& preset : process::preset_uses()) list.push_back(as_json(preset));
    std::printf("%s\n", json_text(list).c_str());
    return kDone;
  }
  std::printf(
      "Values of [powder] preset (Bierwisch 2009), those for die filling first. A scene can override any "
      "property; set powder.apparent_density to your measured value.\n");
  for (const auto& preset : process::preset_uses()) print(preset);
  return kDone;
}

}  // namespace

void add_powders(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("powders", "List the built-in powders: use, limits, density");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print JSON, SI units");
  command->footer("Examples:\n  diefill powders\n  diefill powders --json");
  command->callback([json, &chosen] { chosen = [json] { return powders(*json); }; });
}

}  // namespace diefill::app
