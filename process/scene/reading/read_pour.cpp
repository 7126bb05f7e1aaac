#include <cmath>
#include <numbers>

#include "geometry/mesh/mesh.h"
#include "process/results/storage/result_file.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/read_sphere_file.h"
#include "process/scene/reading/sections.h"
#include "process/scene/saved_state.h"
#include "process/scene/setting.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kCorner = {Dimension::length, "18 mm", "-10 m", "10 m"};
constexpr QuantityRule kFillHeight = {Dimension::length, "24 mm", "0 mm", "1 m", true};
constexpr NumberRule kSolidFraction = {0.05, 0.74, false,
                                       "0.32"};  // 0.74: the densest packing of equal spheres
constexpr QuantityRule kRimSpeed = {Dimension::velocity, "0.05 m/s", "0 m/s", "1 m/s"};
constexpr NumberRule kLatticeConstant = {1, 5, false, "1.2"};
constexpr NumberRule kRandomOffset = {0, 0.5, false, "0.1"};
/// Lattice and offset over d of powder that would settle in columns: grains are anywhere in their cells and
/// touch none (A1 settles at 0.47, published 0.48: Bierwisch 2009, Table 4.4).
constexpr double kRandomLattice = 2, kRandomPlace = 0.5;

/// Rejects keys of the lattice, and a setting that chooses the grain size, beside `key`, which gives all
/// grains.
void refuse_keys_beside(TableReader& table, const std::string& key, bool has_setting) {
  for (const char* other :
       {"from", "to", "fill_height", "solid_fraction", "rim_speed", "lattice_constant", "random_offset",
        "around_tools", "layers", "state", "state_below", "grains_file"}) {
    const bool own = other == key || (key == "state" && other == std::string("state_below"));
    if (!own && table.has(other)) table.reject(other, "pour." + key + " gives all grains; remove the key");
  }
  if (has_setting)
    table.reject(
        key, "a setting chooses the grain size, but these grains already have a size; remove one of the two");
}

/// Box and solid fraction of grains already placed, so that estimates have their numbers.
PourSpec filled_box(const geometry::Box& box, double solid_volume, int line) {
  PourSpec pour;
  pour.line = line;
  pour.lower = box.lower;
  pour.upper = box.upper;
  pour.fill_height = box.size()[2];
  pour.solid_fraction = solid_volume / box.size().prod();
  return pour;
}

void include_sphere(geometry::Box& box, const Eigen::Vector3d& centre, double radius) {
  box.include(centre + Eigen::Vector3d::Constant(radius));
  box.include(centre - Eigen::Vector3d::Constant(radius));
}

/// Of `grains_file`.
PourSpec placed_pour(TableReader& table, bool has_setting) {
  refuse_keys_beside(table, "grains_file", has_setting);
  geometry::Box box;
  double solid = 0;
  const std::filesystem::path file =
      table.file().parent_path() / table.required_text("grains_file", "grains.csv");
  const SphereRows grains = read_sphere_file(table, "grains_file", kPlacedGrains);
  if (grains.spheres.empty()) table.reject("grains_file", "the file has no grain");
  refuse_grains_in_each_other(grains, file);
  for (const auto& grain : grains.spheres) {
    include_sphere(box, grain.centre, grain.radius);
    solid += 4.0 / 3 * std::numbers::pi * std::pow(grain.radius, 3);
  }
  table.finish();
  PourSpec pour = filled_box(box, solid, table.line());
  pour.grains_file = file;
  return pour;
}

results::PowderState powder_in(const SavedState& state, const TableReader& table) {
  try {
    return powder_of(state);
  } catch (const results::ResultError& error) {
    table.reject("state", std::string("not the directory of a run's results: ") + error.what());
  }
}

/// Of `state`.
PourSpec saved_pour(TableReader& table, bool has_setting) {
  refuse_keys_beside(table, "state", has_setting);
  SavedState state;
  state.directory = table.file().parent_path() / table.required_text("state", "out/settled");
  state.below = table.quantity("state_below", kCorner).value_or(state.below);
  table.finish();
  const results::PowderState powder = powder_in(state, table);
  if (powder.position.empty())
    table.reject(std::isfinite(state.below) ? "state_below" : "state", "no grain of that run is left");
  geometry::Box box;
  double solid = 0;
  for (std::size_t k = 0; k < powder.position.size(); ++k) {
    include_sphere(box, powder.position[k], 0.5 * powder.diameter_of(k));
    solid += powder.solid_volume_of(k);
  }
  PourSpec pour = filled_box(box, solid, table.line());
  pour.state = state;
  return pour;
}

PourSpec read(TableReader& table, const Scene& scene, bool height_of_box) {
  if (table.has("grains_file")) return placed_pour(table, height_of_box);
  if (table.has("state")) return saved_pour(table, height_of_box);
  if (table.has("state_below")) table.reject("state_below", "it cuts the powder of pour.state; give state");
  PourSpec pour;
  pour.line = table.line();
  pour.lower = table.required_point("from", kCorner);
  pour.upper = table.required_point("to", kCorner);
  pour.fill_height =
      height_of_box ? pour.upper[2] - pour.lower[2] : table.required_quantity("fill_height", kFillHeight);
  pour.solid_fraction = table.number("solid_fraction", kSolidFraction).value_or(pour.solid_fraction);
  pour.rim_speed = table.quantity("rim_speed", kRimSpeed).value_or(pour.rim_speed);
  if (stacks_in_columns(scene.powder) && !table.has("lattice_constant") && !table.has("random_offset"))
    pour.lattice_constant = kRandomLattice, pour.random_offset = kRandomPlace;
  pour.lattice_constant = table.number("lattice_constant", kLatticeConstant).value_or(pour.lattice_constant);
  pour.random_offset = table.number("random_offset", kRandomOffset).value_or(pour.random_offset);
  pour.around_tools = table.flag("around_tools").value_or(pour.around_tools);
  pour.layers = read_layers(table, scene);
  table.finish();
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    check_pour(table, pour, powder_of(scene, k), scene.numerics);
  return pour;
}

}  // namespace

PourSpec read_pour(TableReader table, const Scene& scene) {
  return read(table, scene, false);
}

PourSpec read_pour_without_height(TableReader table, const Scene& scene) {
  return read(table, scene, true);
}

}  // namespace diefill::process
