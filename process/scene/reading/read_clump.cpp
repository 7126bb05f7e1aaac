#include "process/scene/reading/read_clump.h"

#include <algorithm>
#include <limits>

#include "engine/powder/clump_union.h"
#include "process/results/formatted.h"
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

/// m between two spheres; negative where they overlap.
double gap_between(const ClumpSphere& one, const ClumpSphere& other) {
  return (one.centre - other.centre).norm() - one.radius - other.radius;
}

/// Touching, but for coordinates that are rounded.
bool touch(const ClumpSphere& one, const ClumpSphere& other) {
  constexpr double kRounded = 0.01;  // of the smaller radius
  return gap_between(one, other) <= kRounded * std::min(one.radius, other.radius);
}

/// Which spheres hang together with the first, over others between them.
std::vector<bool> joined_to_first(const std::vector<ClumpSphere>& spheres) {
  std::vector<bool> joined(spheres.size(), false);
  std::vector<std::size_t> open = {0};
  joined[0] = true;
  while (!open.empty()) {
    const ClumpSphere& from = spheres[open.back()];
    open.pop_back();
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      if (joined[k] || !touch(from, spheres[k])) continue;
      joined[k] = true;
      open.push_back(k);
    }
  }
  return joined;
}

/// A grain in pieces would move as one body across the gaps between them.
void refuse_pieces(TableReader& table, const std::string& key, const std::vector<ClumpSphere>& spheres) {
  const std::vector<bool> joined = joined_to_first(spheres);
  std::size_t from = 0, to = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spheres.size(); ++i)
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      if (!joined[i] || joined[k] || gap_between(spheres[i], spheres[k]) >= least) continue;
      least = gap_between(spheres[i], spheres[k]);
      from = i, to = k;
    }
  if (from == to) return;
  table.reject(key,
               results::formatted("sphere %zu is %.4g mm away from sphere %zu, the nearest of the others, "
                                  "so that the clump is in pieces; let every sphere touch or overlap "
                                  "another one: move it, or give it a larger radius",
                                  to + 1, 1e3 * least, from + 1));
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
  refuse_pieces(table, key, spheres);
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
