#!/bin/sh
# From a fresh Debian 12 machine to passed tests: installs what is missing, checks the format, builds, and runs all
# tests that are not slow.
#   sh tests/run.sh slow          runs the slow physics checks instead
#   sh tests/run.sh PRESET        the same for another preset: debug, asan (address and undefined behaviour), tsan
set -eu
cd "$(dirname "$0")/.."
preset=${1:-release}
sh app/install_packages.sh clang-format-14 chromium ffmpeg python3-numpy python3-pytest || sh app/install_packages.sh
sh tests/format.sh
case $preset in
  release | slow) sh app/build.sh ;;
  *)
    cmake --preset "$preset"
    cmake --build --preset "$preset"
    ;;
esac
ctest --preset "$preset"
