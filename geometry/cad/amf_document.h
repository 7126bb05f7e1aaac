// The text of an AMF file, and where its constellations place its objects: assimp 5.2 takes the angles of an
// instance for its offsets.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// The XML of `file`, unpacked where the file is a ZIP archive, without comments. Throws std::runtime_error
/// where an archive holds no AMF file or is damaged.
std::string amf_document(const std::filesystem::path& file);

/// `document` with no elements `constellation`, so that an importer leaves every object where it is drawn.
std::string without_constellations(std::string document);

/// The parts of `document`: `objects`, called by their id, as its constellations place them, once for every
/// instance, turned about x, then y, then z, then shifted. Objects of no constellation stay as they are.
/// Throws std::runtime_error where an instance's number is none, an instance is of an object or constellation
/// that is not there, or constellations contain each other.
std::vector<CadPart> placed_amf_objects(std::string_view document, std::vector<CadPart> objects);

}  // namespace diefill::geometry
