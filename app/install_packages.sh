#!/bin/sh
# Installs the Debian packages that diefill is built with, and those given as arguments, if any is missing. Needs root or
# sudo only then.
set -eu

packages="g++ cmake ninja-build pkg-config libeigen3-dev libtbb-dev libboost-dev libassimp-dev libminizip-dev libcgal-dev libembree-dev libhdf5-dev
libvtk9-dev libosmesa6-dev libglew-dev libgl1-mesa-dri qt6-base-dev libgtest-dev libbenchmark-dev libcli11-dev
libtomlplusplus-dev nlohmann-json3-dev libocct-data-exchange-dev lib3mf-dev libudunits2-dev voro++-dev libnlopt-dev zlib1g-dev libjs-three
pybind11-dev python3-dev fonts-dejavu-core"

missing=""
for package in $packages "$@"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

as_root=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "diefill: these packages are missing and need root or sudo to be installed:$missing" >&2
    exit 1
  }
  as_root="sudo"
fi
# VTK's Python module conflicts with ParaView's; where that is installed it has to give way.
conflict=""
if dpkg-query -W -f='${Status}' python3-paraview 2>/dev/null | grep -q 'install ok installed'; then
  conflict="python3-paraview-"
fi
echo "installing:$missing"
$as_root apt-get update -qq
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing $conflict >/dev/null
