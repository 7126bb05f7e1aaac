#!/bin/sh
# Builds the coverage-guided fuzzer of the importers with clang's libFuzzer and the address sanitizer:
#   sh tests/fuzz/build_guided.sh build/fuzz && build/fuzz/import_fuzz -max_total_time=3600 build/fuzz/corpus
# Coverage is that of diefill's own files; the libraries behind the importers are Debian's, and run in child processes.
set -eu
source=$(cd "$(dirname "$0")/../.." && pwd)
out=$1
mkdir -p "$out/corpus"
cd "$source"
files="cad_child cad_file cad_parts equal_vertices half_edges mesh mesh_check mesh_crossings mesh_findings mesh_import mesh_repair mesh_wrap
point_grid read_3mf read_curved_faces read_triangles topology triangle triangle_tree winding"
sources=""
for file in $files; do sources="$sources geometry/$file.cpp"; done
# shellcheck disable=SC2086
clang++ -std=c++20 -O1 -g -fsanitize=fuzzer,address -frounding-math -DDIEFILL_LIBFUZZER \
  -DDIEFILL_SOURCE_DIR="\"$source\"" -I. -isystem /usr/include/eigen3 -isystem /usr/include/opencascade \
  -isystem /usr/include/lib3mf tests/fuzz/import_fuzz.cpp tests/geometry/mesh_files.cpp \
  tests/geometry/sample_meshes.cpp $sources -o "$out/import_fuzz" -lassimp -lgmpxx -lgmp -lmpfr -l3MF -lTKXDESTEP \
  -lTKXDEIGES -lTKXCAF -lTKSTEP -lTKIGES -lTKXSBase -lTKLCAF -lTKCDF -lTKMesh -lTKTopAlgo -lTKBRep -lTKG3d -lTKMath \
  -lTKernel
