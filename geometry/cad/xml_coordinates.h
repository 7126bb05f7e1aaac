// Coordinates written in the XML of 3MF and AMF files. The libraries that read these files take "1,5" for 1
// and "a1" for 0 without a message, so that a decimal comma gives a closed surface of another shape.
#pragma once

#include <filesystem>
#include <string_view>

namespace diefill::geometry {

/// The number `written` for `name` of `whose`, such as "a corner". Throws std::runtime_error where it is
/// none.
double xml_number(std::string_view whose, std::string_view name, std::string_view written);

/// Of every model in the archive `file`. Throws std::runtime_error where a coordinate is no number; what is
/// no archive is left to the importer.
void check_3mf_coordinates(const std::filesystem::path& file);

/// Of 3MF as text: x, y and z of each `vertex`. Throws std::runtime_error where one is no number.
void check_vertex_attributes(std::string_view model);

/// Of AMF as text: what the elements x, y and z hold. Throws std::runtime_error where one is no number.
void check_amf_coordinates(std::string_view document);

}  // namespace diefill::geometry
