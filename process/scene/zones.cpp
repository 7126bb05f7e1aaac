#include "process/scene/zones.h"

#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "process/scene/scene_text.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kPlace = {Dimension::length, "0 mm", "-10 m", "10 m"};
constexpr QuantityRule kRadius = {Dimension::length, "8 mm", "0 mm", "10 m"};
constexpr std::array<const char*, 5> kLimits = {"from", "to", "inner_radius", "outer_radius", "heights"};

/// Corners of a box that is not empty; nothing where neither is given.
void read_box(TableReader& table, Zone& zone) {
  if (!table.has("from") && !table.has("to")) return;
  zone.lower = table.required_point("from", kPlace);
  zone.upper = table.required_point("to", kPlace);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!(zone.lower[axis] < zone.upper[axis]))
      table.reject("to", "the box is empty: to must be greater than from along x, y and z");
}

void read_cylinder(TableReader& table, Zone& zone) {
  if (const auto axis = table.point("axis", kPlace)) zone.axis = axis->head<2>();
  zone.outer_radius = table.quantity("outer_radius", kRadius).value_or(zone.outer_radius);
  zone.inner_radius = table.quantity("inner_radius", kRadius).value_or(zone.inner_radius);
  if (!(zone.inner_radius < zone.outer_radius))
    table.reject("outer_radius", "allowed: more than inner_radius");
}

void read_heights(TableReader& table, Zone& zone) {
  const std::vector<double> heights = table.quantities("heights", kPlace);
  if (heights.empty()) return;
  if (heights.size() != 2 || !(heights[0] < heights[1]))
    table.reject("heights", "allowed: two heights, the lower one first");
  zone.lower[2] = std::max(zone.lower[2], heights[0]);
  zone.upper[2] = std::min(zone.upper[2], heights[1]);
}

/// Limits that each allow something, but no place together.
void refuse_nothing(const TableReader& table, const Zone& zone) {
  if (!(zone.lower[2] < zone.upper[2]))
    table.reject("heights",
                 "these heights lie beside those of from and to: the zone contains nothing; change "
                 "one of the two, or remove it");
  double nearest = 0, farthest = 0;  // squares of distances of the box from the axis
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const double below = zone.lower[axis] - zone.axis[axis], above = zone.upper[axis] - zone.axis[axis];
    nearest += std::pow(std::max({below, -above, 0.0}), 2);
    farthest += std::pow(std::max(-below, above), 2);
  }
  if (std::sqrt(nearest) >= zone.outer_radius)
    table.reject("outer_radius",
                 "the box of from and to lies outside this cylinder: the zone contains nothing; "
                 "change box or cylinder (its axis is vertical, through axis)");
  if (std::sqrt(farthest) <= zone.inner_radius)
    table.reject("inner_radius",
                 "the box of from and to lies within this radius: the zone contains nothing; "
                 "change box or cylinder (its axis is vertical, through axis)");
}

Zone read_zone(TableReader& table) {
  Zone zone;
  zone.name = table.required_name("name", "flange");
  if (std::none_of(kLimits.begin(), kLimits.end(), [&](const char* key) { return table.has(key); }))
    table.reject("name", "a zone needs a limit: from and to, inner_radius or outer_radius, or heights");
  read_box(table, zone);
  read_cylinder(table, zone);
  read_heights(table, zone);
  refuse_nothing(table, zone);
  table.finish();
  return zone;
}

}  // namespace

std::vector<Zone> read_zones(TableReader& measure) {
  std::vector<Zone> zones;
  for (TableReader& table : measure.tables("zone")) {
    Zone zone = read_zone(table);
    // Figures keep letters and digits of a name alone.
    const auto same = [&](const Zone& other) {
      return zone_mass_figure(other.name) == zone_mass_figure(zone.name);
    };
    const auto taken = std::find_if(zones.begin(), zones.end(), same);
    if (taken != zones.end())
      table.reject("name", "an earlier zone has a name of the same letters and digits, \"" + taken->name +
                               "\"; give each zone a name of its own");
    zones.push_back(std::move(zone));
  }
  return zones;
}

std::vector<Zone> zones_in(const std::string& scene_text) {
  const std::filesystem::path file = "scene of the results";
  const toml::table document = parse_scene_text(scene_text, file);
  TableReader reader(document, file, "");
  auto measure = reader.table("measure");
  return measure ? read_zones(*measure) : std::vector<Zone>{};
}

}  // namespace diefill::process
