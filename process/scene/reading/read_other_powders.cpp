// [[other_powder]], [[powder_pair]] and the layers of [pour].
#include <algorithm>
#include <cmath>

#include "engine/coarse_graining/methods.h"
#include "process/machine/actions/powder_inflow.h"
#include "process/scene/contact/contact_spec.h"
#include "process/scene/powder/grain_models.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"
#include "process/scene/reading/wall_rules.h"

namespace diefill::process {
namespace {

constexpr NumberRule kShare = {0, 1, true, "0.02"};
constexpr NumberRule kFriction = {0, 10, false, "0.3"};
constexpr QuantityRule kAdhesion = {Dimension::work_of_adhesion, "0.01 J/m^2", "0 J/m^2", "10 J/m^2"};
/// Types of grains have numbers of one byte in results.
constexpr std::size_t kMaxTypes = 255;

std::string names_of(const Scene& scene) {
  std::string names;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k)
    names += (k == 0 ? "\"" : ", \"") + powder_of(scene, k).label + '"';
  return names;
}

std::size_t number_of(TableReader& table, const std::string& key, const std::string& name,
                      const Scene& scene) {
  const auto number = powder_named(scene, name);
  if (!number) table.reject(key, "no powder has this name; allowed: " + names_of(scene));
  return *number;
}

OtherPowder read_other(TableReader& table, const Scene& scene) {
  OtherPowder other;
  const std::string name = table.required_name("name", "copper");
  if (powder_named(scene, name)) table.reject("name", "another powder has this name; choose a second one");
  other.share = table.number("share", kShare).value_or(0);
  other.wall_friction = table.number("wall_friction", kWallFriction);
  other.wall_work_of_adhesion = table.quantity("wall_work_of_adhesion", kWallAdhesion);
  if (table.has("air_viscosity"))
    table.reject("air_viscosity", "all powders fall through the same air; give it in [powder]");
  if (table.has("fitted_with")) table.reject("fitted_with", "a key of [powder]");
  table.table("contact");  // read with [contact], once all powders are known
  other.powder = read_powder(table);
  if (scene.walls.kind == WallKind::spheres)
    check_wall_is_tight(table, scene.walls.sphere_radius, scene.walls.spacing, other.powder);
  return other;
}

std::size_t place_of_pair(const Scene& scene, std::size_t first, std::size_t second) {
  const auto is_it = [&](const PowderPair& pair) { return pair.first == first && pair.second == second; };
  return static_cast<std::size_t>(std::find_if(scene.powder_pairs.begin(), scene.powder_pairs.end(), is_it) -
                                  scene.powder_pairs.begin());
}

/// What all pairs have where the scene says nothing.
void add_pairs(Scene& scene) {
  const std::size_t powders = scene.other_powders.size() + 1;
  for (std::size_t i = 0; i < powders; ++i)
    for (std::size_t j = i + 1; j < powders; ++j)
      scene.powder_pairs.push_back({i, j, mean_powder(powder_of(scene, i), powder_of(scene, j)), nullptr});
}

void read_pair(TableReader& table, Scene& scene) {
  PowderPair& pair = scene.powder_pairs[named_pair(table, scene)];
  const auto friction = table.number("friction", kFriction);
  const auto adhesion = table.quantity("work_of_adhesion", kAdhesion);
  pair.powder.friction = friction.value_or(pair.powder.friction);
  pair.powder.work_of_adhesion = adhesion.value_or(pair.powder.work_of_adhesion);
  const bool named = table.table("contact").has_value();
  table.finish();
  if (!friction && !adhesion && !named)
    table.reject("powders", "this pair changes nothing; give friction, work_of_adhesion or contact");
}

void refuse_rolling_beside_clumps(TableReader& powder, const Scene& scene) {
  bool rolls = false, clumps = false;
  for (std::size_t k = 0; k <= scene.other_powders.size(); ++k) {
    rolls = rolls || powder_of(scene, k).rolling_friction > 0;
    clumps = clumps || !has_single_spheres(powder_of(scene, k));
  }
  if (rolls && clumps)
    throw SceneError(powder.where(powder.has("rolling_friction") ? "rolling_friction" : "preset") +
                     ": rolling friction acts against the spin of single spheres, and another powder has "
                     "clumps, whose spheres have none of their own; set rolling_friction = \"0 mm\"");
}

/// Shares of mixed powders.
void check_shares(std::vector<TableReader>& tables, const Scene& scene, bool layers) {
  double sum = 0;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const double share = scene.other_powders[k].share;
    sum += share;
    if (!layers && share == 0) tables[k].require("share", "0.02");
    if (sum >= 1)
      tables[k].reject("share", "shares of the other powders add up to " + number_text(sum) +
                                    "; they must leave something for [powder]");
  }
}

void check_inflow(const Scene& scene, bool mixed) {
  for (const auto& step : scene.steps) {
    const PowderInflow* inflow = step->inflow();
    if (inflow == nullptr) continue;
    if (!inflow->powder.empty() && !powder_named(scene, inflow->powder))
      throw SceneError(inflow->where + ": powder: found \"" + inflow->powder +
                       "\", allowed: " + names_of(scene));
    if (inflow->powder.empty() && !mixed)
      throw SceneError(inflow->where +
                       ": this step does not say which powder comes in, and the powders do "
                       "not form a mixture; add powder, allowed: " +
                       names_of(scene));
  }
}

void check_scaling(TableReader& document, const Scene& scene) {
  if (!scene.contact || engine::coarse_graining::parameter_rule(scene.contact->coarse_graining)) return;
  const double factor = coarse_graining_factor(scene.powder);
  for (const auto& other : scene.other_powders) {
    const double its = coarse_graining_factor(other.powder);
    if (std::abs(its / factor - 1) > 1e-6)
      document.table("contact")->reject(
          "coarse_graining", "this rule scales all forces by one factor, but grains of \"" +
                                 scene.powder.label + "\" are enlarged " + number_text(factor) +
                                 " times and those of \"" + other.powder.label + "\" " + number_text(its) +
                                 " times; make the two equal by grain_diameter or choose \"bierwisch\"");
  }
}

}  // namespace

std::size_t named_pair(TableReader& table, const Scene& scene) {
  table.require("powders", "[\"iron\", \"copper\"]");
  const auto names = table.texts("powders", "[\"iron\", \"copper\"]");
  if (names.size() != 2 || names[0] == names[1])
    table.reject("powders", "give the names of two different powders; allowed: " + names_of(scene));
  const std::size_t one = number_of(table, "powders", names[0], scene),
                    other = number_of(table, "powders", names[1], scene);
  return place_of_pair(scene, std::min(one, other), std::max(one, other));
}

void read_other_powders(TableReader& document, Scene& scene) {
  auto tables = document.tables("other_powder");
  auto pairs = document.tables("powder_pair");
  for (TableReader& table : tables) scene.other_powders.push_back(read_other(table, scene));
  if (tables.empty() && !pairs.empty())
    pairs.front().reject("powders",
                         "the scene has one powder only; add [[other_powder]] or remove the table");
  if (tables.empty()) return;
  std::size_t types = grain_diameters(scene.powder).size();
  for (const auto& other : scene.other_powders) types += grain_diameters(other.powder).size();
  if (types > kMaxTypes)
    tables.back().reject("name", "the powders have " + std::to_string(types) +
                                     " grain sizes together, allowed: " + std::to_string(kMaxTypes));
  add_pairs(scene);
  std::vector<std::size_t> named;
  for (TableReader& table : pairs) {
    const std::size_t pair = named_pair(table, scene);
    if (std::find(named.begin(), named.end(), pair) != named.end())
      table.reject("powders", "another [[powder_pair]] names the same two; merge the tables");
    named.push_back(pair);
    read_pair(table, scene);
  }
  TableReader powder = document.required_table("powder");
  refuse_rolling_beside_clumps(powder, scene);
  OtherContacts contacts = read_other_contacts(document, nullptr, scene);
  for (std::size_t k = 0; k < contacts.powders.size(); ++k)
    scene.other_powders[k].contact = std::move(contacts.powders[k]);
  for (std::size_t k = 0; k < contacts.pairs.size(); ++k)
    scene.powder_pairs[k].contact = std::move(contacts.pairs[k]);
  check_scaling(document, scene);
}

std::vector<PourLayer> read_layers(TableReader& pour, const Scene& scene) {
  std::vector<PourLayer> layers;
  double sum = 0;
  for (TableReader& table : pour.tables("layers")) {
    PourLayer layer;
    layer.powder = number_of(table, "powder", table.required_text("powder", "copper"), scene);
    table.require("share", "0.5");
    layer.share = *table.number("share", kShare);
    table.finish();
    sum += layer.share;
    layers.push_back(layer);
  }
  constexpr double kWhole = 1e-6;
  if (!layers.empty() && std::abs(sum - 1) > kWhole)
    pour.reject("layers",
                "shares of the fill height add up to " + number_text(sum) + "; they must add up to 1");
  return layers;
}

void check_mixture(TableReader& document, const Scene& scene) {
  auto tables = document.tables("other_powder");
  check_shares(tables, scene, !scene.pour.layers.empty());
  const bool mixed =
      std::ranges::all_of(scene.other_powders, [](const auto& other) { return other.share > 0; });
  check_inflow(scene, mixed);
}

}  // namespace diefill::process
