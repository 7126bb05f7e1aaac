// Prints the volume of a tool, in mm^3. The path of its CAD file, in mm, is given.
#include <diefill/geometry/cad/mesh_import.h>

#include <cstdio>

int main(int, char** words) {
  std::printf("%.1f mm^3\n", 1e9 * diefill::geometry::import_mesh(words[1], 0.001).volume());
}
