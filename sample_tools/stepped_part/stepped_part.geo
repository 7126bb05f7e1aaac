// The cavity of the press part of two levels as a mesh for the simulation of pressing, in mm:
// gmsh -3 -format msh41 -o stepped_part.msh stepped_part.geo
SetFactory("OpenCASCADE");
Box(1) = {-8, -5, -12, 8, 10, 12};
Box(2) = {0, -5, -6, 8, 10, 6};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("powder") = {3};
Mesh.MeshSizeMin = 2;
Mesh.MeshSizeMax = 2;
Mesh.SaveAll = 0;
