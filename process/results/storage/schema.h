// The HDF5 schema, defined once: writer and reader walk through the same description, so what is written can
// be read. README.md lists the same for people. Raise kSchemaVersion with every change here; what is added as
// a list or an optional group keeps older files readable.
#pragma once

#include <string>
#include <utility>

#include "process/results/figure_table.h"
#include "process/results/fill_result.h"

namespace diefill::results {

inline constexpr const char* kFormat = "diefill results";
inline constexpr int kSchemaVersion = 6, kOldestSchemaVersion = 1;

template <class Archive, class Powder>
void describe_kinds(Archive& archive, Powder& powder) {
  archive.optional_group("kinds", "particle types of powder of several sizes", !powder.monodisperse(), [&] {
    auto& kinds = powder.kinds;
    archive.field("diameter", kinds.diameter, "m", "grain size d of each type");
    archive.field("sphere_radius", kinds.sphere_radius, "m", "radius of the basic spheres of each type");
    archive.field("grain_mass", kinds.mass, "kg", "mass of one grain of each type");
    archive.field("grain_solid_volume", kinds.solid_volume, "m^3", "solid volume of one grain of each type");
    archive.field("material", kinds.material, "text", "material of each type");
    archive.field("of_grain", powder.kind, "1", "number of every grain's type, from 0");
    archive.optional_group("shapes", "spheres of each type where shapes differ", !kinds.spheres.empty(), [&] {
      archive.field("spheres", kinds.spheres, "1", "spheres of one grain of each type");
      archive.field("offsets", kinds.sphere_offsets, "m", "centres in the body frame, type after type");
      archive.field("radius", kinds.sphere_radii, "m", "radii in the same order");
    });
  });
}

template <class Archive, class Powder>
void describe_powder(Archive& archive, Powder& powder) {
  archive.group("powder", "the powder at one instant; arrays run over grains", [&] {
    archive.field("time", powder.time, "s", "time since the start of the scene");
    archive.field("grain_diameter", powder.grain_diameter, "m", "model grain size d");
    archive.field("sphere_radius", powder.sphere_radius, "m",
                  "radius of the basic spheres that grains are made of");
    archive.field("grain_mass", powder.grain_mass, "kg", "mass of one grain");
    archive.field("grain_solid_volume", powder.grain_solid_volume, "m^3", "solid volume of one grain");
    archive.field("sphere_offsets", powder.sphere_offsets, "m", "sphere centres in the grain's body frame");
    archive.optional_group(
        "unequal_spheres", "where a grain's spheres differ in size", !powder.sphere_radii.empty(),
        [&] { archive.field("radius", powder.sphere_radii, "m", "of each sphere of a grain"); });
    archive.optional_group("period", "lengths after which the same grains follow again, 0: never",
                           powder.period[0] > 0 || powder.period[1] > 0, [&] {
                             archive.field("x", powder.period[0], "m", "period along x");
                             archive.field("y", powder.period[1], "m", "period along y");
                           });
    archive.optional_group("vertical_period", "the same along z", powder.period[2] > 0,
                           [&] { archive.field("z", powder.period[2], "m", "period along z"); });
    archive.field("id", powder.id, "1", "identity of the grain, kept through restarts");
    archive.field("position", powder.position, "m", "grain centres, laboratory frame, z up");
    archive.field("orientation", powder.orientation, "1", "unit quaternion (w, x, y, z), body to laboratory");
    archive.field("velocity", powder.velocity, "m/s", "velocity of the grain centre");
    archive.field("angular_velocity", powder.angular_velocity, "rad/s", "angular velocity, laboratory frame");
    describe_kinds(archive, powder);
  });
}

template <class Archive, class Summary>
void describe_summary(Archive& archive, Summary& summary) {
  const char* scope = "statistics over closed cells in the cavity at least 2 d below the powder surface";
  archive.group("summary", scope, [&] {
    archive.field("mean", summary.mean, "1", "sum of solid volumes over sum of cell volumes");
    archive.field("arithmetic_mean", summary.arithmetic_mean, "1", "mean of the grains' solid fractions");
    archive.field("std", summary.std, "1", "standard deviation of the grains' solid fractions");
    archive.field("min", summary.min, "1", "smallest solid fraction");
    archive.field("max", summary.max, "1", "largest solid fraction");
    archive.field("cv", summary.cv, "1", "standard deviation over arithmetic mean");
    archive.field("grains", summary.grains, "1", "grains counted");
  });
}

template <class Archive, class Result>
void describe_solid_fraction(Archive& archive, Result& result) {
  auto& fraction = result.solid_fraction;
  archive.group("solid_fraction", "Voronoi measure of every grain, in the order of /powder", [&] {
    archive.field("cell_volume", fraction.cell_volume, "m^3", "volume of the grain's Voronoi cell");
    archive.field("solid_fraction", fraction.solid_fraction, "1",
                  "solid volume of the grain over its cell volume");
    archive.field("open", fraction.open, "1",
                  "1 where the cell reaches a free surface: its volume means nothing");
    archive.field("in_cavity", fraction.in_cavity, "1", "1 where the grain centre lies in the cavity");
    describe_summary(archive, result.summary);
  });
}

template <class Archive, class Stress>
void describe_contact_stress(Archive& archive, Stress& stress) {
  const char* scope =
      "stress times volume from contacts, compression negative, of every grain in the order of /powder";
  archive.optional_group("contact_stress", scope, !stress.normal.empty(), [&] {
    archive.field("normal", stress.normal, "J", "components xx, yy, zz");
    archive.field("shear", stress.shear, "J", "components yz, xz, xy");
  });
}

template <class Archive, class Tools>
void describe_tools(Archive& archive, Tools& tools) {
  const auto name_of = [](const ToolState& tool) { return tool.name; };
  archive.list("tools", "tools as they stood at the time of the powder", tools, name_of, [&](auto& tool) {
    archive.field("name", tool.name, "text", "name of the tool in the scene");
    archive.field("role", tool.role, "text", "die, core, punch, shoe or plate");
    archive.field("vertices", tool.vertices, "m", "mesh vertices, laboratory frame");
    archive.field("triangles", tool.triangles, "1", "vertex numbers, counter-clockwise seen from outside");
    archive.field("wall_sphere_centres", tool.wall_sphere_centres, "m",
                  "wall sphere centres, laboratory frame");
    archive.field("wall_sphere_radius", tool.wall_sphere_radius, "m", "radius of the wall spheres");
    archive.field("mesh_hash", tool.mesh_hash, "text", "hash of the CAD file's bytes");
  });
}

template <class Archive, class Cavity>
void describe_cavity(Archive& archive, Cavity& cavity) {
  archive.field("is_ring", cavity.is_ring, "1", "1 for a cavity with a vertical axis and a core");
  archive.field("axis_origin", cavity.axis_origin, "m", "point of the ring's axis at the fill plane");
  archive.field("inner_radius", cavity.inner_radius, "m", "smallest inner radius of the ring");
  archive.field("outer_radius", cavity.outer_radius, "m", "largest outer radius of the ring");
  archive.field("lower_corner", cavity.lower_corner, "m", "lower corner of the box around the cavity");
  archive.field("upper_corner", cavity.upper_corner, "m",
                "upper corner of that box; its z is the fill plane");
  archive.field("volume", cavity.volume, "m^3", "volume below the fill plane, 0 if unknown");
  archive.field("narrowest_width", cavity.narrowest_width, "m", "smallest horizontal width, 0 if unknown");
  archive.field("azimuth_zero", cavity.azimuth_zero, "1",
                "direction of azimuth 0; azimuth counts counter-clockwise");
}

template <class Archive, class Result>
void describe_cavities(Archive& archive, Result& result) {
  archive.group("cavity", "where the powder is collected", [&] { describe_cavity(archive, result.cavity); });
  const auto name_of = [](const CavityState&) { return std::string("cavity"); };
  archive.optional_list("other_cavities", "smaller cavities of a die with several, numbered from 2",
                        result.other_cavities, name_of,
                        [&](auto& cavity) { describe_cavity(archive, cavity); });
}

template <class Archive, class Field>
void describe_field(Archive& archive, Field& field) {
  archive.field("quantity", field.quantity, "text", "what the values are");
  archive.field("first_name", field.first_name, "text", "name of the first coordinate");
  archive.field("first_unit", field.first_unit, "text", "unit of the first coordinate");
  archive.field("second_name", field.second_name, "text", "name of the second coordinate");
  archive.field("second_unit", field.second_unit, "text", "unit of the second coordinate");
  archive.field("first", field.first, "see first_unit", "nodes along the first coordinate, n of them");
  archive.field("second", field.second, "see second_unit", "nodes along the second coordinate, m of them");
  archive.field("value", field.value, "1", "m x n values, the first coordinate runs fastest; NaN: no powder");
  archive.field("averaging_width", field.averaging_width, "m", "Gaussian width of the average over grains");
}

template <class Archive, class Sections>
void describe_sections(Archive& archive, Sections& sections) {
  const auto name_of = [](const SectionField& section) { return section.plane.name; };
  archive.list(
      "sections", "fields in planes; coordinates from the origin", sections, name_of, [&](auto& section) {
        archive.field("name", section.plane.name, "text", "name of the plane");
        archive.field("origin", section.plane.origin, "m", "origin of the plane, laboratory frame");
        archive.field("normal", section.plane.normal, "1", "unit normal of the plane");
        archive.field("first_axis", section.plane.first_axis, "1", "direction of the first coordinate");
        archive.field("second_axis", section.plane.second_axis, "1", "direction of the second coordinate");
        archive.group("field", "the field in the plane", [&] { describe_field(archive, section.field); });
      });
}

template <class Archive, class Profiles>
void describe_profiles(Archive& archive, Profiles& profiles) {
  const auto name_of = [](const Profile& profile) { return profile.quantity; };
  archive.list("profiles", "curves, such as fill level against azimuth", profiles, name_of,
               [&](auto& profile) {
                 archive.field("quantity", profile.quantity, "text", "what y is");
                 archive.field("unit", profile.unit, "text", "unit of y");
                 archive.field("x_name", profile.x_name, "text", "what x is");
                 archive.field("x_unit", profile.x_unit, "text", "unit of x");
                 archive.field("x", profile.x, "see x_unit", "abscissae");
                 archive.field("y", profile.y, "see unit", "ordinates; NaN where nothing was found");
               });
}

template <class Archive, class Checks>
void describe_tool_checks(Archive& archive, Checks& checks) {
  const auto name_of = [](const ToolCheck& check) { return check.tool; };
  archive.list("tool_checks", "findings of the CAD check", checks, name_of, [&](auto& check) {
    archive.field("tool", check.tool, "text", "name of the tool");
    archive.field("file", check.file, "text", "name of its CAD file");
    archive.field("findings", check.findings, "text", "remarks about the mesh");
    archive.field("volume", check.volume, "m^3", "volume that the mesh encloses");
    archive.field("mean_deviation", check.mean_deviation, "m",
                  "mean distance of the wall spheres' envelope from the CAD surface");
    archive.field("largest_deviation", check.largest_deviation, "m", "the same, largest");
    archive.field("largest_gap", check.largest_gap, "m", "largest gap between wall spheres");
  });
}

template <class Archive, class Stages>
void describe_stages(Archive& archive, Stages& stages) {
  const auto name_of = [](const Stage& stage) { return stage.words; };
  archive.list("stages", "the schedule as it happened", stages, name_of, [&](auto& stage) {
    archive.field("tool", stage.tool, "text", "tool that moved; empty: none");
    archive.field("words", stage.words, "text", "what was done");
    archive.field("start", stage.start, "s", "since the start of the scene");
    archive.field("end", stage.end, "s", "since the start of the scene");
  });
}

template <class Archive, class Topics>
void describe_topics(Archive& archive, Topics& topics) {
  const auto name_of = [](const Topic& topic) { return topic.topic; };
  archive.list("topics", "statements about the run, by topic", topics, name_of, [&](auto& topic) {
    archive.field("topic", topic.topic, "text", "the topic");
    archive.field("name", topic.name, "text", "names of the statements");
    archive.field("text", topic.text, "text", "the statements, as many as names");
  });
}

template <class Archive, class Instants>
void describe_instants(Archive& archive, Instants& instants) {
  const auto name_of = [](const Instant&) { return std::string("instant"); };
  archive.optional_list("instants", "the powder at earlier times", instants, name_of, [&](auto& instant) {
    archive.field("time", instant.time, "s", "time since the start of the scene");
    archive.field("id", instant.id, "1", "identity of the grain");
    archive.field("position", instant.position, "m", "grain centres, laboratory frame, z up");
    archive.field("orientation", instant.orientation, "1",
                  "unit quaternion (w, x, y, z), body to laboratory");
    archive.field("velocity", instant.velocity, "m/s", "velocity of the grain centre");
    archive.optional_group("kinds", "particle types of powder of several sizes", !instant.kind.empty(), [&] {
      archive.field("of_grain", instant.kind, "1", "as /powder/kinds/of_grain");
    });
    archive.field("tool_orientation", instant.tool_orientation, "1",
                  "unit quaternion that turns every tool from its place in /tools, in their order");
    archive.field("tool_displacement", instant.tool_displacement, "m", "shift of every tool after turning");
  });
}

template <class Archive, class Probes>
void describe_probes(Archive& archive, Probes& probes) {
  const auto name_of = [](const ProbeSeries& probe) { return probe.name; };
  archive.list("probes", "what probes recorded while the scene ran", probes, name_of, [&](auto& probe) {
    archive.field("name", probe.name, "text", "name of the probe in the scene");
    archive.field("columns", probe.columns, "text", "names of the columns; the first is the time");
    archive.field("units", probe.units, "text", "units of the columns");
    archive.field("values", probe.values, "see units", "row after row, as many values each as columns");
  });
}

template <class Archive, class Result>
void describe_scene(Archive& archive, Result& result) {
  archive.group("scene", "what was run, enough to run it again", [&] {
    archive.field("title", result.title, "text", "title for people");
    archive.field("strategy", result.strategy, "text", "filling strategy in one line");
    archive.field("powder_name", result.powder_name, "text", "name of the powder");
    archive.field("text", result.scene_text, "text", "the scene file as read");
    archive.field("program_version", result.program_version, "text", "version of the program");
    archive.field("seed", result.seed, "1", "seed of all random numbers");
    archive.field("state_hash", result.state_hash, "text", "hash of the engine's final state");
    archive.field("warnings", result.warnings, "text", "warnings for people");
  });
}

/// Walks through everything; `Result` is FillResult for reading and const FillResult for writing.
template <class Archive, class Result>
void describe(Archive& archive, Result& result) {
  describe_scene(archive, result);
  describe_powder(archive, result.powder);
  describe_solid_fraction(archive, result);
  describe_contact_stress(archive, result.contact_stress);
  describe_tools(archive, result.tools);
  describe_cavities(archive, result);
  const auto quantity_of = [](const Field2D& field) { return field.quantity; };
  archive.list("maps", "cylindrical maps of rings", result.maps, quantity_of,
               [&](auto& map) { describe_field(archive, map); });
  describe_sections(archive, result.sections);
  describe_profiles(archive, result.profiles);
  describe_instants(archive, result.instants);
  describe_probes(archive, result.probes);
  archive.numbers("figures", "single numbers of the run, as in report.json", result.figures, figure_meaning);
  const auto phase_meaning = [](const std::string&) {
    return std::pair("s", "wall-clock time in this phase");
  };
  archive.numbers("phase_seconds", "wall-clock time by phase of the step", result.phase_seconds,
                  phase_meaning);
  describe_tool_checks(archive, result.tool_checks);
  describe_stages(archive, result.stages);
  describe_topics(archive, result.topics);
}

}  // namespace diefill::results
