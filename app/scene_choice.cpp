#include "app/scene_choice.h"

#include <cstdio>
#include <optional>

#include "process/plan/setting.h"
#include "process/run/material.h"

namespace diefill::app {

void add_setting(CLI::App& command, std::string& setting) {
  command.add_option("--setting", setting,
                     "quick, working or reference: the planner's grain diameter, time step, wall spacing and "
                     "fill height in place of the scene's own numbers");
}

void say_what_was_chosen(const process::Scene& scene) {
  const auto chosen = process::chosen_in(scene.text);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    std::fprintf(stderr, k == 0 ? "%s:\n" : "  %s\n", chosen[k].c_str());
}

process::Scene wanted_scene(const std::string& file, const std::string& setting) {
  std::optional<process::Setting> wanted;
  if (!setting.empty()) wanted = process::setting_named(setting);
  auto scene = process::plan::settled_scene(process::read_scene(file), wanted);
  say_what_was_chosen(scene);
  return scene;
}

process::Tooling prepared_tooling(const process::Scene& scene, bool show_progress) {
  process::Progress progress(show_progress);
  const double sphere = process::smallest_sphere(process::engine_settings(scene, 1.0));
  return process::build_tooling(scene, sphere, process::largest_grain(scene.powder), progress.listener());
}

}  // namespace diefill::app
