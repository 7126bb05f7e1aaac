// Finite-element meshes as VTU files, read and written with VTK.
#pragma once

#include <filesystem>

#include "process/results/solid_mesh.h"
#include "render/scene3d/paraview_files.h"

namespace diefill::render {

/// Reads a mesh; lengths are multiplied by `unit` (m). Numbers are those of the file's global ids, or else
/// count from 0 as ParaView shows them. Cells without volume are left out and counted. Throws
/// std::invalid_argument with the reason, in one line without the file's name.
results::SolidMesh read_vtu(const std::filesystem::path& file, double unit);

/// Writes the mesh (m) with values of its nodes and elements, and their numbers as "number" of both. The file
/// is written whole or not at all. Throws std::invalid_argument where an array does not fit.
void write_vtu(const std::filesystem::path& file, const results::SolidMesh& mesh,
               const std::vector<PointArray>& node_arrays, const std::vector<PointArray>& element_arrays);

}  // namespace diefill::render
