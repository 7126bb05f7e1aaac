#include "tests/geometry/sample_tool_files.h"

#include <cmath>
#include <numbers>

#include "geometry/cad/mesh_import.h"
#include "project_paths.h"

namespace diefill::geometry::sample {

Mesh tool(const std::string& file) {
  return import_mesh(std::string(DIEFILL_SOURCE_DIR "/sample_tools/") + file, 0.001);
}

// Corner n of the rim belongs to angle 2 pi n / facets; each quadrant's facets are joined to that quadrant's
// corner.
Mesh bored_block(double half, double height, double radius, int facets) {
  Mesh mesh;
  for (const double z : {0.0, -height}) {
    for (int i = 0; i < facets; ++i) {
      const double angle = 2 * std::numbers::pi * i / facets;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  for (const double z : {0.0, -height}) {
    for (const auto& [x, y] : {std::pair{half, half}, {-half, half}, {-half, -half}, {half, -half}})
      mesh.vertices.emplace_back(x, y, z);
  }
  const auto add = [&](int a, int b, int c) { mesh.triangles.emplace_back(a, b, c); };
  const auto rim = [&](int level, int i) { return level * facets + i % facets; };
  const auto corner = [&](int level, int k) { return 2 * facets + level * 4 + k % 4; };
  for (int i = 0; i < facets; ++i) {
    const int quadrant = 4 * i / facets;
    add(rim(0, i), rim(1, i + 1), rim(1, i));
    add(rim(0, i), rim(0, i + 1), rim(1, i + 1));
    add(rim(0, i + 1), rim(0, i), corner(0, quadrant));
    add(rim(1, i), rim(1, i + 1), corner(1, quadrant));
  }
  for (int k = 0; k < 4; ++k) {
    const int middle = (k + 1) * facets / 4;
    add(rim(0, middle), corner(0, k), corner(0, k + 1));
    add(rim(1, middle), corner(1, k + 1), corner(1, k));
    add(corner(0, k), corner(1, k), corner(1, k + 1));
    add(corner(0, k), corner(1, k + 1), corner(0, k + 1));
  }
  return mesh;
}

}  // namespace diefill::geometry::sample
