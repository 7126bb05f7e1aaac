#!/bin/sh
# From a fresh Debian 12 machine to passed tests: installs what is missing, checks the format, builds (diefill-mpi too),
# and runs all tests that are not slow.
#   sh tests/run.sh slow          runs the slow physics checks instead
#   sh tests/run.sh PRESET        the same for another preset: debug, asan (address and undefined behaviour), tsan
set -eu
cd "$(dirname "$0")/.."
preset=${1:-release}
mpi=--mpi
sh app/install_packages.sh clang-format-14 chromium ffmpeg python3-numpy python3-pytest liblammps-dev libopenmpi-dev \
  openmpi-bin || { mpi=""; sh app/install_packages.sh; }
sh tests/format.sh
case $preset in
  release | slow) sh app/build.sh $mpi ;;
  *)
    cmake --preset "$preset"
    cmake --build --preset "$preset"
    ;;
esac
result=0
ctest --preset "$preset" || result=$?
# CTest counts a suite of most programs as one test; GoogleTest counts what is in it.
folder=build
[ "$preset" = release ] || [ "$preset" = slow ] || folder=build-$preset
awk '/^\[  PASSED  \]/ { passed += $4 } / FAILED TESTS?$/ { failed += $1 }
  END { printf "GoogleTest: %d tests passed, %d failed\n", passed, failed }' "$folder/Testing/Temporary/LastTest.log"
exit $result
