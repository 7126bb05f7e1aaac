// What a CAD file holds: named parts as triangles, and the unit of length where the file states one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// One solid of a CAD file. Coordinates count in the file's unit of length.
struct CadPart {
  std::string name;  ///< as in the file, made unique by a number in brackets; "part 1" where it has none
  Mesh mesh;
  std::string plain_name = {};  ///< without that number
  /// Assemblies that it is in, from the outside inwards: name and number of the place, "press#2".
  std::vector<std::string> assemblies = {};
};

/// The parts of a file in its order.
struct CadParts {
  std::vector<CadPart> parts;
  std::optional<double> metres_per_unit;  ///< nothing where the file does not say
  std::vector<std::string> remarks;       ///< oddities of the file
};

/// How the surface of a kind of CAD file is described.
enum class SurfaceKind { kTriangles, kCurved };

/// One kind of CAD file.
struct CadFormat {
  std::string ending;  ///< lower case, without the dot
  SurfaceKind surface = SurfaceKind::kTriangles;
  bool states_unit = false;  ///< files of this kind say what unit their coordinates are in
};

/// All kinds that are read, best known first.
const std::vector<CadFormat>& cad_formats();

/// The kind that the file's ending names, whatever its case; nothing when it is none of cad_formats().
const CadFormat* cad_format(const std::filesystem::path& file);

/// The endings of all formats as a list, such as "STL, OBJ or STEP".
std::string cad_formats_text();

/// Reads `file` in this process: the libraries behind it may crash on unexpected bytes, which is why
/// import_part() uses a child process (cad_child.h). Curved surfaces become triangles whose edges and faces
/// are within `chord_tolerance` (m) of them. Throws std::runtime_error with the reason, which does not name
/// the file.
CadParts read_cad_parts(const std::filesystem::path& file, const CadFormat& format, double chord_tolerance);

}  // namespace diefill::geometry
