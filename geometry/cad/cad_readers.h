// The readers behind read_cad_parts(), one library each. They throw std::runtime_error with the reason.
#pragma once

#include "geometry/cad/cad_parts.h"

namespace diefill::geometry {

/// OBJ, PLY, OFF, AMF, Collada, glTF (assimp). Formats whose y axis points up are turned so that z does.
CadParts read_triangles(const std::filesystem::path& file, const CadFormat& format);

/// 3MF (lib3mf): the mesh objects that the build items hold, however deep, placed. Supports for printing are
/// left out, with a remark.
CadParts read_3mf(const std::filesystem::path& file);

/// STEP and IGES (OpenCASCADE). A part is a product that holds faces, placed as the assembly places it. One
/// larger than 10 m, whose unit must be wrong, is triangulated to no finer than 1e-4 of its size. Loads
/// OpenCASCADE if load_opencascade() has not.
CadParts read_curved_faces(const std::filesystem::path& file, const CadFormat& format,
                           double chord_tolerance);

/// Loads OpenCASCADE, once, for the child processes that read with it. Throws MissingLibrary when it is not
/// installed.
void load_opencascade();

}  // namespace diefill::geometry
