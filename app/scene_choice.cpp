#include "app/scene_choice.h"

#include <cstdio>
#include <optional>

#include "process/plan/setting.h"
#include "process/plan/variant_setting.h"
#include "process/run/foreseen_work.h"
#include "process/run/material.h"

namespace diefill::app {

CLI::Option* add_setting(CLI::App& command, std::string& setting) {
  return command.add_option(
      "--setting", setting,
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
  process::refuse_endless(scene);
  say_what_was_chosen(scene);
  return scene;
}

std::vector<process::Variant> wanted_variants(const std::string& file, const std::string& setting) {
  auto variants = process::read_variants(file);
  if (setting.empty()) {
    for (const auto& variant : variants)
      if (!process::setting_of(variant.scene)) process::refuse_endless(variant.scene);
    return variants;
  }
  variants = process::plan::with_setting(std::move(variants), process::setting_named(setting));
  std::vector<std::string> said;
  for (const auto& variant : variants) {
    const auto chosen = process::chosen_in(variant.scene.text);
    if (chosen == said) continue;
    std::fprintf(stderr, "from \"%s\" on, ", variant.name.c_str());
    say_what_was_chosen(variant.scene);
    said = chosen;
  }
  return variants;
}

process::Tooling prepared_tooling(const process::Scene& scene, bool show_progress) {
  process::Progress progress(show_progress);
  const double sphere = process::smallest_sphere(process::engine_settings(scene, 1.0));
  return process::build_tooling(scene, sphere, process::largest_grain(scene.powder), progress.listener());
}

}  // namespace diefill::app
