// Reads one part of a CAD file as a Mesh in metres. Formats: cad_parts.h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/mesh/mesh.h"

namespace diefill::geometry {

/// What to take from a CAD file, and how.
struct ImportOptions {
  std::optional<double> metres_per_unit;  ///< as stated by the caller, 0.001 for mm
  std::string part;                       ///< its name in the file; empty: everything in the file as one
  double chord_tolerance = 1.5e-6;        ///< m, between curved surfaces and the triangles made of them
};

/// The result.
struct ImportedPart {
  Mesh mesh;                       ///< m
  double metres_per_unit = 0;      ///< of the file
  bool unit_from_file = false;     ///< whether the file itself states its unit
  bool curved = false;             ///< whether the triangles are an approximation within the chord tolerance
  std::vector<std::string> parts;  ///< names of all parts of the file, in its order
  std::vector<std::string> remarks;  ///< oddities of the file that were ignored
};

enum class ChildFailure : char;  // cad_child.h

/// The reader for the file's format, in a process of its own, gave no shapes.
struct UnreadableFile : MeshError {
  UnreadableFile(const std::string& message, ChildFailure why) : MeshError(message), failure(why) {}
  ChildFailure failure;
};

/// The wanted part is not in the file.
struct UnknownPart : MeshError {
  UnknownPart(const std::string& message, std::vector<std::string> names)
      : MeshError(message), known(std::move(names)) {}
  std::vector<std::string> known;  ///< names of the parts that are
};

/// A library that reads files of this format is not installed: no fault of the file. The message is one line
/// for people: finding, what to do.
struct MissingLibrary : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads `file`; wanted_parts() defines which parts a name selects. Vertices closer than 1e-7 of the bounding
/// box's diagonal are merged; parts are placed by the file's transformations. Throws MeshError when the file
/// is missing, a directory, empty, truncated, of unknown format, has no unit and none is given, states
/// another unit than the one given, or holds no triangles or coordinates that are not finite; UnreadableFile
/// when a library cannot read it, crashes or takes too much; UnknownPart when there is no part of that name;
/// MissingLibrary when the library that reads the format is not installed.
ImportedPart import_part(const std::filesystem::path& file, const ImportOptions& options);

/// Everything in `file`, whose coordinates are in units of `metres_per_unit` (0.001 for mm), as one mesh.
Mesh import_mesh(const std::filesystem::path& file, double metres_per_unit);

/// Hash of the bytes of a file and of those that it refers to (referred_files.h), as 16 hexadecimal digits,
/// so that results can name the CAD they were made with. Throws MeshError when a file cannot be read.
std::string file_hash(const std::filesystem::path& file);

}  // namespace diefill::geometry
