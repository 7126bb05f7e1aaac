// Reads the user's finite-element mesh from a text file of Gmsh, Abaqus or CalculiX.
#pragma once

#include <filesystem>

#include "process/results/solid_mesh.h"

namespace diefill::process {

/// A mesh of Gmsh, text, version 2.2 or 4.1; lengths are multiplied by `unit` (m). Elements without volume
/// are left out and counted. Throws SceneError, in one line with file and line, for other versions, binary
/// files, elements that no press simulation has (results::ElementShape), and whatever cannot be read.
results::SolidMesh read_gmsh(const std::filesystem::path& file, double unit);

/// The *NODE and *ELEMENT blocks of an input file of Abaqus or CalculiX, which must be flat: no *INCLUDE, no
/// parts and instances, no generated nodes or elements. Elements: C3D4, C3D5, C3D6, C3D8, C3D10, C3D15, C3D20
/// and what their names continue with, such as C3D8R; others are left out and counted. Errors as above.
results::SolidMesh read_inp(const std::filesystem::path& file, double unit);

}  // namespace diefill::process
