#!/bin/sh
# Installs what is missing, configures and builds the release preset into build/. Arguments go to the build.
set -eu
cd "$(dirname "$0")/.."
sh app/install_packages.sh
mkdir -p build
cmake --preset release >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
cmake --build --preset release "$@"
