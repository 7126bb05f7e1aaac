#include "process/results/storage/result_check.h"

#include "process/results/storage/result_file.h"

namespace diefill::results {
namespace {

void same_or_none(const std::string& what, std::size_t found, std::size_t grains) {
  if (found == grains || found == 0) return;
  throw ResultError(what + " has " + std::to_string(found) + " entries for " + std::to_string(grains) +
                    " grains");
}

void check_kinds(const ParticleTypes& kinds, const std::vector<std::uint8_t>& kind, std::size_t grains) {
  same_or_none("particle types", kind.size(), grains);
  const std::size_t count = kinds.size();
  if (kinds.sphere_radius.size() != count || kinds.mass.size() != count ||
      kinds.solid_volume.size() != count || kinds.material.size() != count)
    throw ResultError("the table of particle types has columns of unequal lengths");
  std::size_t spheres = 0;
  for (const std::uint32_t own : kinds.spheres) spheres += own;
  if ((!kinds.spheres.empty() && kinds.spheres.size() != count) || kinds.sphere_offsets.size() != spheres ||
      kinds.sphere_radii.size() != spheres)
    throw ResultError("the spheres of particle types do not add up to the lists of centres and radii");
  for (const std::uint8_t number : kind)
    if (number >= count)
      throw ResultError("a grain is of type " + std::to_string(number) + ", but there are " +
                        std::to_string(count) + " types, counted from 0");
}

void check_spheres(const PowderState& powder) {
  if (!powder.sphere_radii.empty() && powder.sphere_radii.size() != powder.sphere_offsets.size())
    throw ResultError("the powder has " + std::to_string(powder.sphere_radii.size()) + " sphere radii for " +
                      std::to_string(powder.sphere_offsets.size()) + " spheres of a grain");
}

void check_field(const Field2D& field, const std::string& where) {
  if (field.value.size() != field.first.size() * field.second.size())
    throw ResultError(where + " \"" + field.quantity + "\" has " + std::to_string(field.value.size()) +
                      " values on a grid of " + std::to_string(field.first.size()) + " by " +
                      std::to_string(field.second.size()));
}

void check_tool(const ToolState& tool) {
  const int vertices = static_cast<int>(tool.vertices.size());
  for (const auto& triangle : tool.triangles)
    if (triangle.minCoeff() < 0 || triangle.maxCoeff() >= vertices)
      throw ResultError("tool \"" + tool.name + "\" has a triangle with missing vertices");
}

}  // namespace

void check_lengths(const FillResult& result) {
  const PowderState& powder = result.powder;
  const std::size_t grains = powder.position.size();
  same_or_none("powder id", powder.id.size(), grains);
  same_or_none("powder orientation", powder.orientation.size(), grains);
  same_or_none("powder velocity", powder.velocity.size(), grains);
  same_or_none("powder angular velocity", powder.angular_velocity.size(), grains);
  check_kinds(powder.kinds, powder.kind, grains);
  check_spheres(powder);
  same_or_none("cell volume", result.solid_fraction.cell_volume.size(), grains);
  same_or_none("solid fraction", result.solid_fraction.solid_fraction.size(), grains);
  same_or_none("open cells", result.solid_fraction.open.size(), grains);
  same_or_none("grains in the cavity", result.solid_fraction.in_cavity.size(), grains);
  same_or_none("contact stress", result.contact_stress.normal.size(), grains);
  same_or_none("contact shear stress", result.contact_stress.shear.size(), grains);
  for (const ToolState& tool : result.tools) check_tool(tool);
  for (const Topic& topic : result.topics)
    if (topic.name.size() != topic.text.size())
      throw ResultError("topic \"" + topic.topic + "\" has unequal numbers of names and texts");
  for (const Instant& instant : result.instants) {
    const std::size_t there = instant.position.size();
    check_kinds(result.powder.kinds, instant.kind, there);
    const bool whole = instant.id.size() == there && instant.orientation.size() == there &&
                       instant.velocity.size() == there &&
                       instant.tool_orientation.size() == result.tools.size() &&
                       instant.tool_displacement.size() == result.tools.size();
    if (!whole)
      throw ResultError("instant at t = " + std::to_string(instant.time) +
                        " s: its arrays have unequal lengths");
  }
  for (const Field2D& map : result.maps) check_field(map, "map");
  for (const SectionField& section : result.sections) check_field(section.field, "section");
  for (const Profile& profile : result.profiles)
    if (profile.x.size() != profile.y.size())
      throw ResultError("profile \"" + profile.quantity + "\" has unequal numbers of x and y");
}

}  // namespace diefill::results
