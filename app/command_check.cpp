#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "process/run/fill_run.h"
#include "process/run/material.h"
#include "process/run/pour.h"

namespace diefill::app {

namespace {

void print_tool(const process::Tool& tool) {
  const Eigen::Vector3d size = 1e3 * tool.mesh.bounding_box().size();
  std::printf("%s (%s): %zu triangles, %.2f x %.2f x %.2f mm, volume %.4g cm3\n", tool.spec.name.c_str(),
              process::in_words(tool.spec.role).c_str(), tool.mesh.triangles.size(), size[0], size[1],
              size[2], 1e6 * tool.mesh.volume());
  for (const auto& finding : tool.findings.in_words()) std::printf("  mesh: %s\n", finding.c_str());
  if (tool.findings.in_words().empty()) std::printf("  mesh: closed, oriented, free of self-intersections\n");
  const auto& spheres = tool.spheres;
  std::printf(
      "  wall spheres: %zu of radius %.4g mm; envelope to CAD surface: mean %.3g mm, largest %.3g mm; "
      "largest gap "
      "%.3g mm\n",
      spheres.centres.size(), 1e3 * spheres.radius, 1e3 * spheres.mean_deviation,
      1e3 * spheres.largest_deviation, 1e3 * spheres.largest_gap);
}

void print_cavity(const geometry::Cavity& cavity) {
  if (!cavity.found) {
    std::printf("cavity: none below the fill plane\n");
    return;
  }
  std::printf("cavity: volume %.4g cm3, depth %.2f mm, narrowest width %.3f mm", 1e6 * cavity.volume,
              1e3 * cavity.box.size()[2], 1e3 * cavity.narrowest_width);
  if (cavity.is_ring)
    std::printf(", ring of %.2f to %.2f mm diameter", 2e3 * cavity.inner_radius, 2e3 * cavity.outer_radius);
  std::printf("\n");
}

int check(const std::string& file) {
  const process::Scene scene = process::read_scene(file);
  const auto shape = process::engine_settings(scene, 1.0).shape;
  const auto tooling = process::build_tooling(scene, shape.sphere_radius, scene.powder.grain_diameter);
  process::RunOptions options;
  options.threads = 1;
  options.show_progress = false;
  const process::FillRun run(scene, tooling, options);

  for (const auto& tool : tooling.tools) print_tool(tool);
  print_cavity(tooling.cavity);
  const auto& simulation = run.simulation();
  std::printf("powder: %s, %zu grains of d = %.4g mm, %zu spheres; %zu wall spheres\n",
              scene.powder.name.c_str(), simulation.grains().size(), 1e3 * scene.powder.grain_diameter,
              simulation.grains().size() * simulation.settings().shape.spheres(), tooling.wall_spheres());
  std::printf("time step: %.3g s, %.2f of the critical %.3g s\n", simulation.settings().time_step,
              simulation.settings().time_step / run.critical_time_step(), run.critical_time_step());
  std::printf("strategy: %s, %.3g s and the time to come to rest\n",
              process::strategy_in_words(scene).c_str(), run.schedule().time_left(0, 0));
  for (const auto& warning : run.warnings()) std::printf("note: %s\n", warning.c_str());
  return kDone;
}

}  // namespace

void add_check(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("check", "Examine the tools and the scene without simulating");
  auto file = std::make_shared<std::string>();
  command->add_option("SCENE", *file, "scene file (TOML)")->required();
  command->footer(
      "Prints for each tool what its mesh is like, how many wall spheres stand for it, how far their "
      "envelope is from the\n"
      "CAD surface and the largest gap between them; then cavity, powder and time step.\n"
      "Example:\n  diefill check sample_tools/narrow_ring/fill.toml");
  command->callback([file, &chosen] { chosen = [file] { return check(*file); }; });
}

}  // namespace diefill::app
