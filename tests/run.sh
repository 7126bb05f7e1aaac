#!/bin/sh
# From a fresh Debian 12 machine to passed tests: installs what is missing, checks format and scripts, builds (diefill-mpi
# too), and runs all tests that are not slow. At the end it says what is not tested because packages cannot be installed; tests
# that are missing although their packages are installed are a failure.
#   sh tests/run.sh slow          runs the slow physics checks instead
#   sh tests/run.sh PRESET        the same for another preset: debug, asan (address and undefined behaviour), tsan
set -eu
cd "$(dirname "$0")/.."
preset=${1:-release}
folder=build
[ "$preset" = release ] || [ "$preset" = slow ] || folder=build-$preset

# What is tested only with packages that the build itself does not need, the names of these tests as CTest lists them
# (none: the tests are there, but do less), and the packages.
optional="format of the sources||clang-format-14
lint of scripts||shellcheck pyflakes3
Python package|python[.]Package|python3-numpy python3-pytest
Python package against h5py, and its tutorial||python3-h5py python3-matplotlib
views in a browser|app[.]View|chromium
films||ffmpeg
runs on ranks|cluster[.]OnRanks|liblammps-dev libopenmpi-dev openmpi-bin
whole scenes on ranks|app[.]Ranks|liblammps-dev libopenmpi-dev openmpi-bin"

installed() {
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || return 1
  done
}

# shellcheck disable=SC2046
sh app/install_packages.sh $(echo "$optional" | cut -d '|' -f 3) || {
  sh app/install_packages.sh
  echo "$optional" | cut -d '|' -f 3 | while read -r packages; do
    # shellcheck disable=SC2086
    sh app/install_packages.sh $packages </dev/null || true
  done
}
mpi=""
if installed liblammps-dev libopenmpi-dev openmpi-bin; then mpi=--mpi; fi

sh tests/format.sh
sh tests/lint.sh
case $preset in
  release | slow) sh app/build.sh $mpi ;;
  *)
    mkdir -p "$folder"
    cmake --preset "$preset" >"$folder/configure.log" 2>&1 || { cat "$folder/configure.log" >&2; exit 1; }
    cmake --build --preset "$preset"
    ;;
esac
result=0
ctest --preset "$preset" || result=$?
# CTest counts a suite of most programs as one test; GoogleTest counts what is in it.
awk '/^\[  PASSED  \]/ { passed += $4 } / FAILED TESTS?$/ { failed += $1 }
  END { printf "GoogleTest: %d tests passed, %d failed\n", passed, failed }' "$folder/Testing/Temporary/LastTest.log"

grep 'left out' "$folder/configure.log" | sed 's/^-- //' || true
listed=$folder/listed_tests
ctest --preset "$preset" -N >"$listed"
while IFS='|' read -r what tests packages; do
  if [ -n "$tests" ] && grep -q ": $tests" "$listed"; then continue; fi
  # shellcheck disable=SC2086
  if ! installed $packages; then
    echo "NOT TESTED: $what; cannot be installed: $packages"
  # Sanitized builds leave Python and ranks out, and the slow tests are others.
  elif [ "$preset" = release ] && [ -n "$tests" ]; then
    echo "MISSING: tests of $what, although their packages are installed: $packages" >&2
    result=1
  fi
done <<END
$optional
END
exit $result
