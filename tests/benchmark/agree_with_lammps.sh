#!/bin/sh
# Compares diefill with LAMMPS from the same start: an agitated lattice of 5,096 spheres collapses and settles, same
# contact law, same step, double precision. Prints solid fraction and coordination number of the settled beds and the
# kinetic energy over the first 20 ms, and ends with exit code 1 where they differ by more than 0.5 %, 2 % and 5 %.
#
#   sh tests/benchmark/agree_with_lammps.sh [STEPS]
#
# STEPS: of 2e-6 s, 50000 by default. Environment: DIEFILL (program, default build/bin/diefill), KEEP (folder to leave the
# histories and final states in). What differs between the codes: LAMMPS takes contact forces with velocities of the half
# step, diefill with predicted ones, so that single trajectories part while the bed as a whole must not.
set -eu

steps=${1:-50000}
here=$(cd "$(dirname "$0")" && pwd)
diefill=${DIEFILL:-$here/../../build/bin/diefill}
[ -x "$diefill" ] || { echo "agree_with_lammps: $diefill is not there; build it first: sh app/build.sh" >&2; exit 2; }

command -v lmp >/dev/null || {
  as_root=""
  [ "$(id -u)" -eq 0 ] || as_root="sudo"
  $as_root apt-get update -qq
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends lammps >/dev/null
}

if [ -n "${KEEP:-}" ]; then
  work=$KEEP
  mkdir -p "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$work/ours" "$work/lammps"

python3 "$here/agreement/collapse.py" make "$work/state.csv" "$work/state.data"
"$diefill" bench spheres --state "$work/state.csv" --width "$(python3 "$here/agreement/collapse.py" width)" --steps "$steps" \
  --trace "$work/ours" --every 50
OMP_NUM_THREADS=1 lmp -in "$here/agreement/in.collapse" -var data "$work/state.data" -var steps "$steps" -var every 50 \
  -var out "$work/lammps" -log none -screen "$work/lammps/screen" >/dev/null
python3 "$here/agreement/collapse.py" compare "$work/ours" "$work/lammps"
