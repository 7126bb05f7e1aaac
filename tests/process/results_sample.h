// A small result with every field filled, no two alike, for tests of files.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "process/results/fill_result.h"

namespace diefill::results {

inline PowderState sample_powder(int grains) {
  PowderState powder;
  powder.time = 0.1 + 0.2;  // not 0.3, to the last bit
  powder.grain_diameter = 4.7e-4;
  powder.sphere_radius = 7.84e-5;
  powder.grain_mass = 7.63e-8;
  powder.grain_solid_volume = 1.413e-11;
  powder.period = {0, 2.16e-3};
  powder.sphere_offsets = {{0, 0, 0}, {1.568e-4, 0, 0}, {0, -1.568e-4, 1e-300}};
  for (int k = 0; k < grains; ++k) {
    const double x = std::sin(1.0 + k), y = std::cos(2.0 + 3 * k), z = std::sin(0.5 * k * k);
    powder.id.push_back(std::numeric_limits<std::uint64_t>::max() - 7 * static_cast<std::uint64_t>(k));
    powder.position.emplace_back(1e-3 * x, 1e-3 * y, 1e-3 * z);
    powder.orientation.push_back(Eigen::Vector4d(1, x, y, z).normalized());
    powder.velocity.emplace_back(y, -z, k == 0 ? -0.0 : x);
    powder.angular_velocity.emplace_back(1e5 * z, 5e-324, -1e5 * x);
  }
  return powder;
}

inline ToolState sample_tool(const std::string& name, const std::string& role) {
  ToolState tool;
  tool.name = name;
  tool.role = role;
  tool.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1.0 / 3.0, 0}, {0, 0, 1}};
  tool.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  tool.wall_sphere_centres = {{0.1, 0.2, 0.3}, {-0.1, 1e-17, 0.7}};
  tool.wall_sphere_radius = 1.5e-4;
  tool.mesh_hash = "hash of " + name;
  return tool;
}

inline Field2D sample_field(const std::string& quantity) {
  const double nan = std::nan("");
  return {quantity, "azimuth",     "deg",    "height",
          "mm",     {0, 120, 240}, {0, 0.1}, {0.3, nan, 0.35, 1.0 / 3.0, 0.4, nan},
          5e-4};
}

inline FillResult sample_result(int grains = 5) {
  FillResult result;
  result.title = "1 passage at 0.2 m/s, Distaloy \"AE\" <d> & more, µ = 1";
  result.strategy = "1 passage at 0.2 m/s";
  result.powder_name = "distaloy_ae";
  result.scene_text = "[powder]\nname = \"distaloy_ae\"\n\n# Füllung\n";
  result.program_version = "0.1.0";
  result.seed = std::numeric_limits<std::uint64_t>::max() - 1;
  result.state_hash = "0123456789abcdef";
  result.powder = sample_powder(grains);
  for (int k = 0; k < grains; ++k) {
    result.solid_fraction.cell_volume.push_back(1e-11 * (3 + k));
    result.solid_fraction.solid_fraction.push_back(1.413 / (3 + k));
    result.solid_fraction.open.push_back(k % 2);
    result.solid_fraction.in_cavity.push_back(k % 3 == 0);
  }
  for (int k = 0; k < grains; ++k) {
    result.contact_stress.normal.emplace_back(-1e-9 * k, -2e-9, -1e-8 / (k + 1));
    result.contact_stress.shear.emplace_back(1e-10 * k, 0, -3e-11);
  }
  result.tools = {sample_tool("die", "die"), sample_tool("a/b c", "plate"), sample_tool("a_b c", "shoe")};
  result.tools[2].triangles.clear();
  result.cavity = {true,
                   {1e-3, 0, 2e-3},
                   8e-3,
                   11.146e-3,
                   {-1.1e-2, -1.1e-2, -1.5e-2},
                   {1.1e-2, 1.1e-2, 0},
                   2.8278783e-6,
                   3.146e-3,
                   {0.6, -0.8, 0}};
  result.summary = {0.341, 0.345, 0.02, 0.21, 0.47, 0.02 / 0.345, 1234567890123ULL};
  result.maps = {sample_field("solid fraction"), sample_field("velocity")};
  result.sections = {
      {{"through the axis", {0, 0, 1e-3}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, sample_field("solid fraction")},
      {{"y z", {1, 2, 3}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, sample_field("solid fraction")}};
  result.profiles = {
      {"fill level", "mm", "azimuth", "deg", {45, 135, 225, 315}, {14.5, std::nan(""), 13.25, 14}}};
  for (const double time : {0.1, 0.2}) {
    const PowderState powder = sample_powder(3);
    result.instants.push_back({time, powder.id, powder.position, powder.orientation, powder.velocity,
                               std::vector<Eigen::Vector4d>(result.tools.size(), {0.6, 0, 0, 0.8}),
                               std::vector<Eigen::Vector3d>(result.tools.size(), {time, 0, -1e-3})});
  }
  result.probes = {{"on the punch", {"time", "force z"}, {"s", "N"}, {0, 0.5, 1e-3, -0.25}},
                   {"none yet", {"time", "mass"}, {"s", "kg"}, {}}};
  result.figures = {{"filled_mass_kg", 1.0 / 3000.0},
                    {"grains", 65000},
                    {"spheres", 455000},
                    {"wall_spheres", 60123},
                    {"steps", 123456789},
                    {"time_step_s", 2e-6},
                    {"simulated_s", 0.7},
                    {"wall_seconds", 99},
                    {"sphere_steps_per_second", 1.25e7},
                    {"energy_balance_error", 3e-4},
                    {"narrowest_mm", 3.1},
                    {"undefined", std::nan("")}};
  result.phase_seconds = {{"detect", 1.5}, {"contact", 20}, {"integrate", 0.1}};
  result.warnings = {"d over ring width is 0.4, beyond 1/3", ""};
  result.tool_checks = {{"die", "die.stl", {"2 degenerate triangles", ""}, 1e-6, 2e-6, 3e-6, 4e-6},
                        {"a/b c", "shoe \u00fc.stl", {}, 5e-6, 6e-6, 7e-6, 8e-6}};
  result.stages = {{"", "settling until at rest", 0, 0.1},
                   {"a/b c", "1 passage at 0.2 m/s", 0.1, 0.3},
                   {"", "settling until at rest", 0.3, 0.30000000000000004}};
  result.topics = {{"powder", {"grain model", "friction"}, {"D", "1"}}, {"versions", {}, {}}};
  return result;
}

}  // namespace diefill::results
