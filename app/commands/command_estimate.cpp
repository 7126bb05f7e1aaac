#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/options/quantities.h"
#include "app/tables/estimate_report.h"
#include "app/tables/json_text.h"
#include "app/tables/variant_estimates.h"
#include "engine/numerics/seconds_since.h"
#include "process/plan/setting.h"
#include "process/setup/read_tooling.h"

namespace diefill::app {

namespace {

struct EstimateArguments {
  std::string scene, setting, variant, particle_diameter, discharge;
  std::vector<std::string> changes;
  bool json = false;
};

/// m. Throws process::SceneError.
double diameter(const std::string& text, const process::Scene& scene) {
  constexpr double kMin = 1e-6, kMax = 1e-2;
  const double grain = process::largest_grain(scene);
  return bounded_quantity("--particle-diameter", text, process::Dimension::length,
                          {kMin, std::min(grain, kMax), false, grain < kMax ? "the scene's grains" : ""});
}

process::estimate::EstimateOptions options_of(const EstimateArguments& arguments,
                                              const process::Scene& scene) {
  process::estimate::EstimateOptions options;
  if (!arguments.particle_diameter.empty())
    options.particle_diameter = diameter(arguments.particle_diameter, scene);
  if (!arguments.discharge.empty()) options.law = process::estimate::read_discharge(arguments.discharge);
  return options;
}

process::Tooling tooling_of(const process::Scene& scene) {
  process::Progress progress(true);
  return process::read_tooling(scene, progress.callback());
}

/// Empty where the scene has no variants, or where --variant or --set is given.
std::vector<VariantEstimate> estimates_of_variants(const EstimateArguments& arguments,
                                                   const process::estimate::EstimateOptions& options) {
  std::vector<VariantEstimate> estimates;
  if (!arguments.variant.empty() || !arguments.changes.empty()) return estimates;
  if (names_of_variants(arguments.scene).empty()) return estimates;
  for (const auto& variant : chosen_variants(arguments.scene, arguments.setting)) {
    const auto scene = process::plan::scene_with_setting(variant.scene, std::nullopt);
    estimates.push_back({variant.name, process::estimate::estimate(scene, tooling_of(scene), options)});
  }
  return estimates;
}

void print_variants(const std::vector<VariantEstimate>& variants) {
  if (variants.empty()) return;
  std::printf("\nThe above is the scene without its [[variant]]s. The variants:\n");
  print_variant_estimates(variants);
  std::printf("for all statements about one variant: --variant, such as --variant \"%s\"\n",
              variants.front().name.c_str());
}

int run_estimate(const EstimateArguments& arguments) {
  const process::Scene scene = arguments.variant.empty()
                                   ? chosen_scene(arguments.scene, arguments.setting, arguments.changes)
                                   : chosen_variant(arguments.scene, arguments.variant, arguments.setting);
  const auto options = options_of(arguments, scene);
  auto began = std::chrono::steady_clock::now();
  const process::Tooling tooling = tooling_of(scene);
  const double reading = engine::seconds_since(began);
  began = std::chrono::steady_clock::now();
  const auto found = process::estimate::estimate(scene, tooling, options);
  const double estimating = engine::seconds_since(began);
  const auto variants = estimates_of_variants(arguments, options);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"title", scene.title}};
    json.update(estimate_as_json(found));
    if (!variants.empty()) json["variants"] = variant_estimates_as_json(variants);
    json["reading_seconds"] = reading;
    json["estimating_seconds"] = estimating;
    std::printf("%s\n", json_text(json).c_str());
    return kDone;
  }
  std::printf("%s\n", scene.title.c_str());
  print_estimate(found);
  std::printf("estimated in %.2f s, after %.1f s of reading the tools\n", estimating, reading);
  print_variants(variants);
  return kDone;
}

}  // namespace

void add_estimate(CLI::App& program, Action& chosen) {
  auto* command =
      program.add_subcommand("estimate", "Estimate filling, shoe speed and air by formula, without grains");
  auto arguments = std::make_shared<EstimateArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML)")->required();
  add_setting(*command, arguments->setting);
  auto* changes = add_changes(*command, arguments->changes);
  add_variant(*command, arguments->variant)->excludes(changes);
  command->add_option(
      "--particle-diameter", arguments->particle_diameter,
      "size of the real particles, such as '80 um', at most the scene's grains, for the effect of "
      "air (default: that of "
      "[suction]; 0.1 mm for presets)");
  command->add_option(
      "--discharge", arguments->discharge,
      "fit.json of diefill fit-discharge (law 5.17, 5.18, transient or beverloo-slit): the law of "
      "your powder");
  command->add_flag("--json", arguments->json, "print JSON, SI units");
  command->footer(
      "For each cavity or slit: mass that runs in and share filled, critical shoe speed, crossings needed, "
      "cycle "
      "time;\nfor a falling punch the mass that follows; whether air matters; Bond, Froude and Pi numbers. "
      "Each "
      "with its\nformula, range and error. Takes under a second once the tools are read. Of a scene with "
      "variants "
      "also a\nline for each of them; --variant gives all statements about one.\n"
      "Examples:\n  diefill estimate sample_tools/narrow_ring/fill.toml\n"
      "  diefill estimate my_die.toml --discharge out/fit/fit.json --particle-diameter '80 um' --json");
  command->callback([arguments, &chosen] { chosen = [arguments] { return run_estimate(*arguments); }; });
}

}  // namespace diefill::app
