// Small meshes as their programs write them.
#pragma once

#include <string>

namespace diefill::process {

/// Two tetrahedra over the unit square's half and its other half, and a triangle and a point beside them.
inline std::string gmsh22(const std::string& version = "2.2 0 8") {
  return "$MeshFormat\n" + version +
         "\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"powder\"\n$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 "
         "0\n3 0 "
         "1 0\n5 0 0 1\n9 1 1 0.5\n10 7 7 7\n$EndNodes\n$Elements\n4\n1 15 2 1 1 10\n2 2 2 1 1 1 2 3\n7 4 2 "
         "1 1 1 2 "
         "3 5\n8 4 2 1 1 2 9 3 5\n$EndElements\n";
}

/// The first of them in version 4.1.
inline std::string gmsh41() {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 1 1 1 0 "
         "0\n$EndEntities\n$Nodes\n2 4 1 "
         "5\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n3 1 0 1\n5\n0 0 1\n$EndNodes\n$Elements\n2 2 2 7\n2 1 2 "
         "1\n2 1 2 "
         "3\n3 1 4 1\n7 1 2 3 5\n$EndElements\n";
}

/// A cube of edge 2 as C3D8R in capitals and small letters, with a comment and a surface element.
inline std::string inp_cube() {
  return "*Heading\n a cube\n** nodes\n*NODE, NSET=all\n1, 0., 0., 0.\n2, 2., 0., 0.\n3, 2., 2., 0.\n4, 0., "
         "2., 0.\n"
         "5, 0., 0., 2.\n6, 2., 0., 2.\n7, 2.0E+0, 2., 2.\n8, 0., 2., +2.\n*element, type=C3D8R,\n "
         "elset=part\n"
         "11, 1, 2, 3, 4,\n 5, 6, 7, 8\n*ELEMENT, TYPE=S3\n12, 1, 2, 3\n*SOLID SECTION, ELSET=part, "
         "MATERIAL=powder\n1.\n*MATERIAL, NAME=powder\n";
}

}  // namespace diefill::process
