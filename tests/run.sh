#!/bin/sh
# From a fresh Debian 12 machine to passed tests: installs what is missing, builds, and runs all tests that are not slow.
# `sh tests/run.sh slow` runs the slow physics checks instead.
set -eu
cd "$(dirname "$0")/.."
sh app/build.sh
if [ "${1:-}" = slow ]; then
  ctest --preset slow
else
  ctest --preset release
fi
