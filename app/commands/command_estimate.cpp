#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/formula_commands.h"
#include "app/commands/scene_choice.h"
#include "app/exit_code.h"
#include "app/tables/estimate_report.h"
#include "app/tables/json_text.h"
#include "process/input/units.h"
#include "process/setup/read_tooling.h"

namespace diefill::app {

namespace {

struct EstimateArguments {
  std::string scene, setting, particle_diameter, discharge;
  std::vector<std::string> changes;
  bool json = false;
};

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

/// m. Throws process::SceneError.
double diameter(const std::string& text) {
  const std::string found = "--particle-diameter: found \"" + text + "\"";
  double value = 0;
  try {
    value = process::parse_quantity(text, process::Dimension::length, "80 um");
  } catch (const process::UnitError& error) {
    throw process::SceneError(found + ": " + error.what());
  }
  constexpr double kMin = 1e-6, kMax = 1e-2;
  if (value < kMin || value > kMax) throw process::SceneError(found + ", allowed: 1 um to 10 mm");
  return value;
}

int run_estimate(const EstimateArguments& arguments) {
  process::estimate::EstimateOptions options;
  if (!arguments.particle_diameter.empty()) options.particle_diameter = diameter(arguments.particle_diameter);
  if (!arguments.discharge.empty()) options.law = process::estimate::read_discharge(arguments.discharge);
  const process::Scene scene = chosen_scene(arguments.scene, arguments.setting, arguments.changes);
  auto began = std::chrono::steady_clock::now();
  const auto tooling = [&] {
    process::Progress progress(true);
    return process::read_tooling(scene, progress.callback());
  }();
  const double reading = seconds_since(began);
  began = std::chrono::steady_clock::now();
  const auto found = process::estimate::estimate(scene, tooling, options);
  const double estimating = seconds_since(began);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"title", scene.title}};
    json.update(estimate_as_json(found));
    json["reading_seconds"] = reading;
    json["estimating_seconds"] = estimating;
    std::printf("%s\n", json_text(json).c_str());
    return kDone;
  }
  std::printf("%s\n", scene.title.c_str());
  print_estimate(found);
  std::printf("estimated in %.2f s, after %.1f s of reading the tools\n", estimating, reading);
  return kDone;
}

}  // namespace

void add_estimate(CLI::App& program, Action& chosen) {
  auto* command =
      program.add_subcommand("estimate", "Estimate filling, shoe speed and air by formula, without grains");
  auto arguments = std::make_shared<EstimateArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML)")->required();
  add_setting(*command, arguments->setting);
  add_changes(*command, arguments->changes);
  command->add_option("--particle-diameter", arguments->particle_diameter,
                      "size of the real particles, such as '80 um', for the effect of air (default: that of "
                      "[suction]; 0.1 mm for presets)");
  command->add_option("--discharge", arguments->discharge,
                      "fit.json of diefill fit-discharge: the law of your powder");
  command->add_flag("--json", arguments->json, "print JSON, SI units");
  command->footer(
      "For each cavity or slit: mass that runs in and share filled, critical shoe speed, crossings needed, "
      "cycle "
      "time;\nfor a falling punch the mass that follows; whether air matters; Bond, Froude and Pi numbers. "
      "Each "
      "with its\nformula, range and error. Takes under a second once the tools are read.\n"
      "Examples:\n  diefill estimate sample_tools/narrow_ring/fill.toml\n"
      "  diefill estimate my_die.toml --discharge out/fit/fit.json --particle-diameter '80 um' --json");
  command->callback([arguments, &chosen] { chosen = [arguments] { return run_estimate(*arguments); }; });
}

}  // namespace diefill::app
