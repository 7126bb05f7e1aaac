// The JSON of a glTF file, and what in it assimp 5.2 misreads without a message.
#pragma once

#include <string>

namespace diefill::geometry {

/// Of the bytes of a .gltf or .glb file; empty where there is none.
std::string json_of_gltf(const std::string& bytes);

/// Throws std::runtime_error where the corners of a mesh are whole numbers (KHR_mesh_quantization), which
/// assimp takes for floating-point ones, or where an extension that the file requires, and that assimp does
/// not know, says where corners are. What is no JSON is left to the importer.
void refuse_unread_corners(const std::string& text);

}  // namespace diefill::geometry
