#!/bin/sh
# Installs what is missing, configures and builds the release preset into build/. Arguments go to the build.
#   sh app/build.sh --mpi    with diefill-mpi, which runs on many machines (process/cluster/README.md)
set -eu
cd "$(dirname "$0")/.."
packages="" options=""
if [ "${1:-}" = --mpi ]; then
  shift
  packages="liblammps-dev libopenmpi-dev openmpi-bin" options=-DDIEFILL_MPI=ON
fi
# shellcheck disable=SC2086
sh app/install_packages.sh $packages
mkdir -p build
# shellcheck disable=SC2086
cmake --preset release $options >build/configure.log 2>&1 || { cat build/configure.log >&2; exit 1; }
cmake --build --preset release "$@"
