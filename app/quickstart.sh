#!/bin/sh
# From a fresh Debian 12 machine to a density map: installs what is missing, builds, and fills the narrow ring die.
set -eu
cd "$(dirname "$0")/.."
sh app/build.sh --target diefill
build/bin/diefill run sample_tools/narrow_ring/fill.toml --out out/narrow_ring
echo "look at $(pwd)/out/narrow_ring/density_map.png"
