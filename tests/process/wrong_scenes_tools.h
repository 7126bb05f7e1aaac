// Faults in [walls] and [[tool]].
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

inline std::vector<WrongScene> wrong_walls() {
  const std::string radius = "sphere_radius = \"0.15 mm\"", spacing = "spacing = 1.6",
                    range = "allowed: at least 0.2 and at most 4";
  return {
      spoil("wall_radius_negative", radius, "sphere_radius = @\"-0.15 mm\"",
            {"walls.sphere_radius", "found \"-0.15 mm\"", "at least 0.001 mm"}),
      spoil("wall_spacing_too_small", spacing, "spacing = @0.199",
            {"walls.spacing", "found 0.199", range, "such as 1.6"}),
      spoil("wall_kind_unknown", spacing, "kind = @\"meshes\"",
            {"walls.kind", "found \"meshes\"", "allowed: \"spheres\" or \"mesh\"", "did you mean \"mesh\"?"}),
      spoil("wall_spacing_too_large", spacing, "spacing = @5", {"walls.spacing", "found 5", range}),
      spoil("wall_spacing_with_unit", spacing, "spacing = @\"0.24 mm\"",
            {"walls.spacing", "found \"0.24 mm\"", "expected a number without quotes or unit"}),
      spoil("wall_leaks", radius + "\n" + spacing, "sphere_radius = \"1 mm\"\nspacing = @3",
            {"walls.spacing", "found 3", "let powder spheres of radius 1.12132 mm or less pass through",
             "the powder has spheres of 0.3136 mm", "smaller spacing"}),
      spoil("wall_friction_negative", spacing, "friction = @-1",
            {"walls.friction", "found -1", "allowed: at least 0 and at most 10"}),
      spoil("wall_key_misspelt", spacing, "@spaceing = 1.6",
            {"walls.spaceing", "found 1.6", "did you mean \"spacing\"?"}),
  };
}

inline std::vector<WrongScene> wrong_tools() {
  const std::string die = "[[tool]]\nname = \"die\"", role = "role = \"die\"", file = "file = \"die.stl\"",
                    unit = "length_unit = \"mm\"";
  const std::string place = "position = [\"35.4 mm\", \"0 mm\", \"0 mm\"]";
  const std::string before_pour = scene_up_to("[pour]"), before_tools = scene_up_to("[[tool]]");
  const std::string all = before_pour.substr(before_tools.size());
  return {
      spoil("no_tools", before_pour, "@" + before_tools,
            {"tool", "found nothing, a value is required", "[[tool]]", "name, role, file and length_unit"}),
      spoil("tool_name_missing", die, "@[[tool]]",
            {"tool.name", "found nothing, a value is required", "such as \"die\""}),
      spoil("tool_friction_negative", die, die + "\nfriction = @-0.1",
            {"tool.friction", "found -0.1", "allowed: at least 0 and at most 10"}),
      spoil("tool_adhesion_without_unit", die, die + "\nwork_of_adhesion = @0.01",
            {"tool.work_of_adhesion", "found 0.01", "J/m^2"}),
      spoil("tool_name_empty", die, "[[tool]]\nname = @\"\"",
            {"tool.name", "found \"\"", "a name of at least one letter"}),
      spoil("tool_name_with_slash", die, "[[tool]]\nname = @\"a/b\"",
            {"tool.name", "found \"a/b\"", "no slash"}),
      spoil("tool_name_twice", "name = \"shoe\"", "name = @\"die\"",
            {"tool.name", "found \"die\"", "the tool on line 12 already has this name"}),
      spoil("tool_role_unknown", role, "role = @\"dye\"",
            {"tool.role", "found \"dye\"", "allowed: \"die\", \"core\", \"punch\", \"shoe\" or \"plate\"",
             "did you mean \"die\"?"}),
      spoil("tool_role_missing", die + "\n" + role, "@" + die,
            {"tool.role", "found nothing", "such as \"die\""}),
      spoil("tool_file_key_missing", die + "\n" + role + "\n" + file, "@" + die + "\n" + role,
            {"tool.file", "found nothing", "\"die.stl\""}),
      spoil("tool_file_absent", file, "file = @\"dye.stl\"",
            {"tool.file", "found \"dye.stl\"", "no such file: /",
             "dye.stl; give the path relative to the scene file"}),
      spoil("tool_file_a_folder", file, "file = @\"parts\"",
            {"tool.file", "found \"parts\"", "this is a folder"}),
      spoil("tool_file_empty", file, "file = @\"\"",
            {"tool.file", "found \"\"", "expected the name of a CAD file"}),
      spoil("tool_file_of_a_program", file, "file = @\"part.sldprt\"",
            {"tool.file", "found \"part.sldprt\"", "export the part as STL, STEP"}),
      spoil("tool_chord_tolerance_of_triangles", unit, unit + "\nchord_tolerance = @\"0.01 mm\"",
            {"tool.chord_tolerance", "found \"0.01 mm\"", "already contains triangles"}),
      spoil("tool_chord_tolerance_negative", file, "file = \"part.step\"\nchord_tolerance = @\"-1 mm\"",
            {"tool.chord_tolerance", "at least 1e-5 mm and at most 1 mm"}),
      spoil("tool_repair_unknown", unit, unit + "\nrepair = @\"save\"",
            {"tool.repair", "found \"save\"", "allowed: \"safe\", \"off\" or \"wrap\"",
             "did you mean \"safe\"?"}),
      spoil("tool_mirror_unknown", unit, unit + "\nmirror = @\"left\"",
            {"tool.mirror", "found \"left\"", "an axis (\"x\""}),
      spoil("tool_part_a_number", unit, unit + "\npart = @3", {"tool.part", "found 3"}),
      spoil("tool_length_unit_missing", die + "\n" + role + "\n" + file + "\n" + unit,
            "@" + die + "\n" + role + "\n" + file,
            {"tool.length_unit", "found nothing", "such as \"mm\"", "does not state its unit"}),
      spoil("tool_length_unit_unknown", unit, "length_unit = @\"millimetre\"",
            {"tool.length_unit", "found \"millimetre\"",
             "allowed: \"mm\", \"um\", \"cm\", \"m\", \"inch\" or \"in\""}),
      spoil("tool_position_of_two", place, "position = @[\"35.4 mm\", \"0 mm\"]",
            {"tool.position", "found [\"35.4 mm\", \"0 mm\"]", "expected three values along x, y and z"}),
      spoil("tool_position_without_unit", place, "position = [\"35.4 mm\", @0, \"0 mm\"]",
            {"tool.position[y]", "found 0,", "expected a length with its unit"}),
      spoil("tool_position_out_of_range", place, "position = [@\"35.4 m\", \"0 mm\", \"0 mm\"]",
            {"tool.position[x]", "found \"35.4 m\"", "allowed: at least -10 m and at most 10 m"}),
      spoil("tool_rotation_without_angle", place, "rotation = @{ axis = \"z\" }",
            {"tool.rotation.angle", "found nothing", "\"90 deg\""}),
      spoil("tool_rotation_axis_unknown", place, "rotation = { axis = @\"w\", angle = \"90 deg\" }",
            {"tool.rotation.axis", "found \"w\"", "an axis (\"x\", \"y\", \"z\""}),
      spoil("tool_rotation_axis_zero", place, "rotation = { axis = @[0, 0, 0], angle = \"90 deg\" }",
            {"tool.rotation.axis", "found [0, 0, 0]", "not all zero"}),
      spoil("tool_rotation_axis_too_short", place,
            "rotation = { axis = @[0, 1e-200, 1e-310], angle = \"90 deg\" }",
            {"tool.rotation.axis", "between 1e-100 and 1e+100", "has no direction"}),
      spoil("tool_rotation_as_number", place, "rotation = { axis = \"z\", angle = @90 }",
            {"tool.rotation.angle", "found 90,", "an angle with its unit", "\"90 deg\""}),
      spoil("tool_of_one_bracket", all, "@[tool]\nname = \"die\"\n\n",
            {"tool", "found a table", "write [[tool]] with double brackets"}),
      spoil("tool_key_misspelt", unit, unit + "\n@rol = \"die\"", {"tool.rol", "did you mean \"role\"?"}),
      spoil("tool_leaks", place, "sphere_radius = \"1 mm\"\nspacing = @3",
            {"tool.spacing", "found 3", "let powder spheres of radius 1.12132 mm or less pass through"}),
  };
}

}  // namespace diefill::process
