#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/shared_options/scene_choice.h"
#include "app/exit_code.h"
#include "app/options/output_file.h"
#include "app/output.h"
#include "app/pictures/drawing.h"
#include "app/tables/check_report.h"
#include "app/tables/estimate_report.h"
#include "app/tables/json_text.h"
#include "engine/observe/powder_figures.h"
#include "process/powder/law_terms.h"
#include "process/powder/material.h"
#include "process/powder/powder_mixture.h"
#include "process/run/fill_run.h"
#include "process/setup/impact_speed.h"
#include "process/setup/pour.h"
#include "process/setup/setup_findings.h"
#include "process/tooling/stages.h"
#include "process/tooling/tool_paths.h"

namespace diefill::app {

namespace {

struct CheckArguments {
  std::string scene, picture, setting, variant;
  std::vector<std::string> changes;
  bool json = false;
};

OutputFile picture_file(const std::string& file) {
  return {"--picture", file, {".png"}};
}

/// Throws process::SceneError where the picture would overwrite a file of the scene, or is not a PNG file.
void require_picture(const CheckArguments& arguments, const process::Scene* scene) {
  if (arguments.picture.empty()) return;
  std::vector<std::filesystem::path> inputs = {arguments.scene};
  if (scene != nullptr) inputs = input_files_of(*scene);
  require_output_file(picture_file(arguments.picture), inputs);
}

void draw_picture(const std::string& file, const process::Scene& scene, const process::Tooling& tooling,
                  const process::Diagnosis& diagnosis, const std::vector<render::FindingMark>& more = {}) {
  if (file.empty()) return;
  set_up_drawing();
  auto marks = more;
  for (auto& mark : marks_of(tooling, diagnosis)) marks.push_back(std::move(mark));
  make_directory_of(picture_file(file));
  write_output([&] { render::draw_findings(file, parts_of(tooling), marks, scene.title); });
}

/// Findings about the set-up, and for information where powder is poured and where shoes go.
std::vector<render::FindingMark> setup_marks(const process::Scene& scene, const process::Tooling& tooling,
                                             const std::vector<process::SetupFinding>& setup) {
  auto marks = marks_of(scene, setup);
  for (const auto& tool : tooling.tools)
    if (tool.spec.role == process::ToolRole::shoe) marks.push_back(path_marker(scene, tool));
  return marks;
}

/// The tools as they are read, for a picture of why they are refused.
process::Tooling read_alone(const process::Scene& scene) {
  process::Tooling tooling;
  for (const auto& spec : scene.tools) tooling.tools.push_back(process::read_tool(scene, spec));
  return tooling;
}

/// The tools, ready to be filled. Those that pass through each other are drawn before they are refused.
process::Tooling checked_tooling(const CheckArguments& arguments, const process::Scene& scene) {
  try {
    return prepared_tooling(scene, true);
  } catch (const process::ToolsCollide& error) {
    std::vector<render::FindingMark> marks;
    for (const auto& collision : error.collisions)
      marks.push_back({render::MarkKind::kFault, collision.description(), {collision.place}});
    if (!arguments.picture.empty()) draw_picture(arguments.picture, scene, read_alone(scene), {}, marks);
    throw;
  }
}

void print_json(const nlohmann::ordered_json& json) {
  std::printf("%s\n", json_text(json).c_str());
}

/// Meshes that enclose no solid: the picture and the JSON show where, before the one line of refusal.
void refuse_unusable(const CheckArguments& arguments, const process::Scene& scene) {
  const process::Tooling tooling = read_alone(scene);
  const bool usable = std::all_of(tooling.tools.begin(), tooling.tools.end(),
                                  [](const auto& tool) { return tool.findings.usable(); });
  if (usable) return;
  draw_picture(arguments.picture, scene, tooling, {});
  if (arguments.json) {
    auto json = tools_as_json(tooling, {});
    json["warnings"] = setup_as_json({});
    print_json(json);
  }
  for (const auto& tool : tooling.tools) process::refuse_unusable(scene, tool);
}

/// What is to be simulated.
struct Predicted {
  std::size_t grains = 0, spheres = 0;
  engine::SimulationSettings settings;
  double critical_step = 0, seconds = 0;
  std::vector<std::string> warnings;
};

/// As the run begins it: every grain is placed, and none may touch a tool.
Predicted placed(const process::Scene& scene, const process::Tooling& tooling) {
  process::RunOptions options;
  options.threads = 1;
  options.show_progress = false;
  const process::FillRun run(scene, tooling, options);
  const auto& simulation = run.simulation();
  return {simulation.grains().size(), engine::sphere_count(simulation), simulation.settings(),
          run.critical_time_step(),   run.schedule().time_left(0, 0),   run.warnings()};
}

std::size_t spheres_to_pour(const process::Scene& scene) {
  return static_cast<std::size_t>(static_cast<double>(process::grains_to_pour(scene)) *
                                  process::mean_of_poured(scene).spheres);
}

/// The same of so many grains that to place them would take a gigabyte.
Predicted counted(const process::Scene& scene, const process::Tooling& tooling) {
  const double impact = process::predicted_impact_speed(scene, tooling);
  Predicted predicted;
  predicted.settings = process::engine_settings(scene, impact);
  predicted.grains = process::grains_to_pour(scene);
  predicted.spheres = spheres_to_pour(scene);
  predicted.critical_step = process::critical_time_step(predicted.settings, impact);
  for (const auto& state : process::predicted(process::Stages(scene), 0))
    predicted.seconds = std::max(predicted.seconds, state.ended);
  predicted.warnings.emplace_back(
      "too many grains to place here, so they are only counted; the run checks at its start whether one "
      "touches a tool");
  return predicted;
}

Predicted predicted_of(const process::Scene& scene, const process::Tooling& tooling) {
  constexpr std::size_t kMaxPlaced = 1000000;  // spheres
  return spheres_to_pour(scene) <= kMaxPlaced ? placed(scene, tooling) : counted(scene, tooling);
}

nlohmann::ordered_json as_json(const Predicted& predicted) {
  return {{"grains", predicted.grains},
          {"spheres", predicted.spheres},
          {"time_step_s", predicted.settings.time_step},
          {"critical_time_step_s", predicted.critical_step}};
}

void print_simulation(const process::Scene& scene, const process::Tooling& tooling,
                      const Predicted& predicted) {
  const auto& settings = predicted.settings;
  std::printf("powder: %s, %zu grains of d = %.4g mm, %zu spheres; %zu wall spheres\n",
              scene.powder.label.c_str(), predicted.grains, 1e3 * scene.powder.grain_diameter,
              predicted.spheres, tooling.wall_spheres());
  if (!scene.powder.sizes.empty())
    std::printf("sizes: %s; d is the size of the mean mass\n", scene.powder.sizes_text.c_str());
  for (const auto& other : scene.other_powders)
    std::printf("with %s: %s\n", other.powder.label.c_str(), process::amount_text(scene, other).c_str());
  std::printf("time step: %.3g s, %.2f of the critical %.3g s\n", settings.time_step,
              settings.time_step / predicted.critical_step, predicted.critical_step);
  std::printf("laws in use: %s\n", process::joined(process::law_terms(scene, settings).used).c_str());
  std::printf("strategy: %s, %.3g s plus settling time\n", process::strategy_text(scene).c_str(),
              predicted.seconds);
  for (const auto& remark : tooling.remarks()) std::printf("note: %s\n", remark.c_str());
  for (const auto& warning : predicted.warnings) std::printf("note: %s\n", warning.c_str());
}

/// The scene's variants that are not checked: none where one of them, or another scene by --set, is.
std::vector<std::string> unchecked_variants(const CheckArguments& arguments) {
  if (!arguments.variant.empty() || !arguments.changes.empty()) return {};
  return names_of_variants(arguments.scene);
}

void print_unchecked(const std::vector<std::string>& variants) {
  if (variants.empty()) return;
  std::printf(
      "this is the scene without its %zu [[variant]]%s; check one with --variant, such as --variant \"%s\"\n",
      variants.size(), variants.size() == 1 ? "" : "s", variants.front().c_str());
}

process::Scene scene_of(const CheckArguments& arguments) {
  return arguments.variant.empty() ? chosen_scene(arguments.scene, arguments.setting, arguments.changes)
                                   : chosen_variant(arguments.scene, arguments.variant, arguments.setting);
}

int check(const CheckArguments& arguments) {
  require_picture(arguments, nullptr);
  process::Scene scene = scene_of(arguments);
  const auto variants = unchecked_variants(arguments);
  require_picture(arguments, &scene);
  if (arguments.json || !arguments.picture.empty()) refuse_unusable(arguments, scene);
  const double sphere = process::smallest_sphere(process::engine_settings(scene, 1.0));
  const auto tooling = checked_tooling(arguments, scene);
  scene = process::with_prepared_steps(std::move(scene), tooling);
  const auto setup = process::setup_findings(scene, tooling);
  const auto predicted = predicted_of(scene, tooling);
  const auto diagnosis = process::diagnose(scene, tooling, sphere);

  draw_picture(arguments.picture, scene, tooling, diagnosis, setup_marks(scene, tooling, setup));
  if (arguments.json) {
    auto json = tools_as_json(tooling, diagnosis);
    json["simulation"] = as_json(predicted);
    json["warnings"] = setup_as_json(setup);
    json["estimate"] = estimate_as_json(process::estimate::estimate(scene, tooling));
    json["unchecked_variants"] = variants;
    print_json(json);
    return kDone;
  }
  print_estimate_in_short(process::estimate::estimate(scene, tooling));
  for (std::size_t k = 0; k < tooling.tools.size(); ++k) print_tool(tooling.tools[k], &diagnosis.symmetry[k]);
  print_pairs(diagnosis);
  print_cavities(tooling);
  print_simulation(scene, tooling, predicted);
  print_unchecked(variants);
  print_alerts(finding_lines(setup));
  if (!arguments.picture.empty()) std::printf("picture: %s\n", arguments.picture.c_str());
  return kDone;
}

}  // namespace

void add_check(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("check", "Check the tools and the scene without simulating");
  auto arguments = std::make_shared<CheckArguments>();
  command->add_option("SCENE", arguments->scene, "scene file (TOML)")->required();
  add_setting(*command, arguments->setting);
  auto* changes = add_changes(*command, arguments->changes);
  add_variant(*command, arguments->variant)->excludes(changes);
  command->add_flag("--json", arguments->json, "print the findings about the tools as JSON, lengths in m");
  command->add_option("--picture", arguments->picture, "write a PNG of the tools with each finding marked");
  command->footer(
      "Prints for each tool the state of its mesh, repairs, the number of wall spheres, the distance of "
      "their\nenvelope from the CAD surface and the largest gap between them; then fits between tools, "
      "cavity, powder and time step.\n"
      "Examples:\n  diefill check sample_tools/narrow_ring/fill.toml\n"
      "  diefill check my_die.toml --picture findings.png");
  command->callback([arguments, &chosen] { chosen = [arguments] { return check(*arguments); }; });
}

}  // namespace diefill::app
