#!/bin/sh
# Builds the coverage-guided fuzzer of the importers with clang's libFuzzer (README.md):
#   sh tests/fuzz/build_guided.sh OUT BUILD [children]
# Readers run inside the fuzzer's process, under the address sanitizer, or with `children` in processes of their own
# under their limits, as in the program.
# BUILD has been built with CMake: what only CGAL's headers make slow to compile is taken from there as it is.
# Coverage is that of diefill's own files, and of assimp where ASSIMP names an archive of it that was built for it.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1/corpus" "$1/objects"
out=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)
flags="-std=c++20 -O1 -gline-tables-only -I$source -isystem /usr/include/eigen3 -isystem /usr/include/opencascade
-isystem /usr/include/lib3mf -I$build/tests/include"
sanitizers=,address
reading=tests/fuzz/read_in_process.cpp
if [ "${3:-}" = children ]; then
  # Limits on memory and the sanitizer's shadow memory do not go together.
  sanitizers=
  reading=
fi
cd "$source"
for file in cad/cad_file cad/cad_parts cad/mesh_import cad/read_3mf cad/read_binary_stl \
  cad/read_triangles grids/distinct_points grids/point_grid mesh/equal_vertices mesh/half_edges mesh/mesh \
  mesh/mesh_check mesh/mesh_findings mesh/topology mesh/triangle mesh/triangle_tree mesh/winding; do
  object=$out/objects/$(basename "$file").o
  # shellcheck disable=SC2086,SC3013  # dash has -nt
  [ "$object" -nt "geometry/$file.cpp" ] ||
    clang++ $flags "-fsanitize=fuzzer-no-link$sanitizers" -c "geometry/$file.cpp" -o "$object"
done
libraries="-lTKXDESTEP -lTKXDEIGES -lTKXCAF -lTKSTEP -lTKIGES -lTKXSBase -lTKLCAF -lTKCDF -lTKMesh -lTKTopAlgo
-lTKBRep -lTKG3d -lTKMath -lTKernel"
# Instrumented as the rest, and found before that of BUILD.
# shellcheck disable=SC2086
clang++ $flags "-fsanitize=fuzzer-no-link$sanitizers" -fPIC -shared geometry/cad/opencascade/step_and_iges.cpp \
  -o "$out/libdiefill_opencascade.so" $libraries
# shellcheck disable=SC2086
clang++ $flags "-fsanitize=fuzzer$sanitizers" tests/fuzz/guided_fuzz.cpp tests/fuzz/fuzz_input.cpp \
  tests/fuzz/shared_coverage.cpp $reading tests/geometry/mesh_files.cpp tests/geometry/sample_meshes.cpp \
  tests/geometry/broken_files.cpp "$out"/objects/*.o "$build/geometry/libdiefill_geometry.a" -o "$out/import_fuzz" \
  ${ASSIMP:--lassimp} -lgmp -lmpfr -ltbb -l3MF "-Wl,-rpath,$out"
