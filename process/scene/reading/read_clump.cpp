#include "process/scene/reading/read_clump.h"

#include "engine/powder/clump_union.h"
#include "process/scene/reading/read_sphere_file.h"

namespace diefill::process {
namespace {

using engine::ClumpSphere;

constexpr QuantityRule kPlace = {Dimension::length, "0.1 mm", "-100 mm", "100 mm"};
constexpr QuantityRule kRadius = {Dimension::length, "0.1 mm", "0 mm", "10 mm", true};
/// Of one grain: its laws and places are computed for each.
constexpr std::size_t kMaxSpheres = 64;
constexpr SphereLimits kOfClump = {0.1, 0.01, 1U << 20U};

std::vector<ClumpSphere> spheres_in_scene(TableReader& table) {
  std::vector<ClumpSphere> spheres;
  for (TableReader& entry : table.tables("spheres")) {
    entry.require("centre", "[\"0.1 mm\", \"0 mm\", \"0 mm\"]");
    ClumpSphere sphere;
    sphere.centre = *entry.point("centre", kPlace);
    sphere.radius = entry.required_quantity("radius", kRadius);
    entry.finish();
    spheres.push_back(sphere);
  }
  return spheres;
}

}  // namespace

void read_clump(TableReader& table, PowderSpec& powder, double density) {
  const bool in_scene = table.has("spheres"), in_file = table.has("spheres_file");
  if (!in_scene && !in_file) return;
  const std::string key = in_scene ? "spheres" : "spheres_file";
  if (in_scene && in_file)
    table.reject("spheres_file", "powder.spheres gives the clump already; remove one of the two");
  for (const char* other : {"model", "sphere_radius"})
    if (table.has(other))
      table.reject(other, "powder." + key + " gives the shape of the grain; remove the key");
  const auto spheres =
      in_scene ? spheres_in_scene(table) : read_sphere_file(table, "spheres_file", kOfClump).spheres;
  if (spheres.empty() || spheres.size() > kMaxSpheres)
    table.reject(key,
                 std::to_string(spheres.size()) + " spheres, allowed: 1 to " + std::to_string(kMaxSpheres));
  constexpr double kUnit = 1;  // kg/m^3
  const double volume = engine::grain_of_union(spheres, kUnit).solid_volume;
  const auto shape = engine::grain_of_union(spheres, density > 0 ? density : powder.grain_mass / volume);
  powder.model = GrainModel::clump;
  powder.sphere_radius = shape.sphere_radius;
  powder.grain_mass = shape.mass;
  powder.rolling_friction = 0;
  powder.clump = std::make_shared<const engine::GrainShape>(shape);
}

}  // namespace diefill::process
