#include "tests/app/pictures/every_picture.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "process/results/storage/result_file.h"

namespace diefill::app {
namespace {

constexpr double kSize = 1e-3;  // m, grains of one sphere

void add_grain(results::FillResult& result, const Eigen::Vector3d& place) {
  auto& powder = result.powder;
  powder.id.push_back(powder.id.size());
  powder.position.push_back(place);
  powder.orientation.emplace_back(1, 0, 0, 0);
  powder.velocity.emplace_back(-place.y(), place.x(), -1e-3);
  powder.angular_velocity.push_back(Eigen::Vector3d::Zero());
  result.solid_fraction.solid_fraction.push_back(0.5 + 5 * place.z());
  result.solid_fraction.cell_volume.push_back(1e-9);
  result.solid_fraction.open.push_back(place.z() > -1e-3);
  result.solid_fraction.in_cavity.push_back(1);
  result.contact_stress.normal.emplace_back(1e-7 * place.z(), 1e-7 * place.z(), 3e-7 * place.z());
  result.contact_stress.shear.emplace_back(0, 0, 0);
}

/// A tetrahedron, so that there is a tool to cut and to move.
results::ToolState small_tool() {
  results::ToolState tool;
  tool.name = tool.role = "shoe";
  tool.vertices = {{-9e-3, -3e-3, 1e-3}, {9e-3, -3e-3, 1e-3}, {0, 6e-3, 1e-3}, {0, 0, 8e-3}};
  tool.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return tool;
}

}  // namespace

results::FillResult small_ring() {
  results::FillResult result;
  result.strategy = "1 passage at 0.2 m/s";
  result.powder_name = "spheres";
  result.powder.time = 0.3;
  result.powder.grain_diameter = kSize;
  result.powder.sphere_radius = kSize / 2;
  result.powder.grain_solid_volume = std::numbers::pi / 6 * std::pow(kSize, 3);
  result.powder.sphere_offsets = {Eigen::Vector3d::Zero()};
  for (double z = -4.5e-3; z < 0; z += kSize)
    for (double radius = 4.5e-3; radius < 8e-3; radius += kSize)
      for (int k = 0; k < 30; ++k) {
        const double angle = 2 * std::numbers::pi * k / 30;
        add_grain(result, {radius * std::cos(angle), radius * std::sin(angle), z});
      }
  result.tools = {small_tool()};
  result.cavity.is_ring = true;
  result.cavity.inner_radius = 4e-3;
  result.cavity.outer_radius = 8e-3;
  result.cavity.lower_corner = {-8e-3, -8e-3, -5e-3};
  result.cavity.upper_corner = {8e-3, 8e-3, 0};
  result.cavity.volume = std::numbers::pi * 48e-6 * 5e-3;
  results::SectionField section;
  section.plane.name = "middle";
  result.sections = {section};
  for (const double time : {0.1, 0.2}) {
    results::Instant instant{time,
                             result.powder.id,
                             result.powder.position,
                             result.powder.orientation,
                             result.powder.velocity,
                             {{1, 0, 0, 0}},
                             {{0.01 * time, 0, 0}}};
    for (auto& place : instant.position) place *= 1 - 0.02 * time;
    result.instants.push_back(instant);
  }
  result.probes = {{"filled mass", {"time", "filled mass"}, {"s", "kg"}, {0, 0, 0.1, 0.001, 0.3, 0.002}},
                   {"shoe", {"time", "force x", "shift x"}, {"s", "N", "m"}, {0, 0, 0, 0.3, 2, 0.06}}};
  return result;
}

void EveryPicture::SetUpTestSuite() {
  unsetenv("DISPLAY");
}

EveryPicture::EveryPicture() {
  results::write_results(one(), small_ring());
  auto other = small_ring();
  for (double& value : other.solid_fraction.solid_fraction) value += 0.01;
  results::write_results(two(), other);
}

Outcome EveryPicture::map(const std::vector<std::string>& more, bool both) const {
  std::vector<std::string> arguments = {"map", one().string()};
  if (both) arguments.push_back(two().string());
  const std::vector<std::string> common = {"--out", out().string(), "--width", "400"};
  arguments.insert(arguments.end(), common.begin(), common.end());
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

}  // namespace diefill::app
