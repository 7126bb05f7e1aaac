#!/bin/sh
# Races diefill against LAMMPS on settled beds: the same state and contact law, double precision, one pinned core, in
# turns, because machines are noisy. Prints every lap and the median of the laps' ratios.
#
#   sh tests/benchmark/against_lammps.sh BEDS [clumps|spheres] [LAPS] [STEPS]
#
# BEDS: folder with clumps.csv.gz, spheres.csv.gz, to_lammps.py and lammps/in.clumps, lammps/in.spheres.
# Environment: DIEFILL (program, default build/bin/diefill), CORE (default 0), CSV (file that laps are added to).
# What differs between the codes: diefill also keeps energy accounts and deepest overlaps in every step, chooses its own
# skin, and turns clumps by forces at the contact point (half the overlap inside the surface), LAMMPS at the surface.
set -eu

[ $# -ge 1 ] || { sed -n '2,11s/^# \{0,1\}//p' "$0" >&2; exit 2; }
beds=$1
which=${2:-clumps spheres}
laps=${3:-7}
steps=${4:-600}
core=${CORE:-0}
here=$(cd "$(dirname "$0")/../.." && pwd)
diefill=${DIEFILL:-$here/build/bin/diefill}
[ -x "$diefill" ] || { echo "against_lammps: $diefill is not there; build it first: sh app/build.sh" >&2; exit 2; }

command -v lmp >/dev/null || {
  as_root=""
  [ "$(id -u)" -eq 0 ] || as_root="sudo"
  $as_root apt-get update -qq
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends lammps >/dev/null
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Million sphere-steps a second of one run of each.
lap_of_lammps() { # bed spheres
  (cd "$beds/lammps" && OMP_NUM_THREADS=1 taskset -c "$core" lmp -in "in.$1" -var data "$work/$1.data" -var steps "$steps" \
    -log none -screen "$work/screen" >/dev/null)
  awk -v n="$2" -v steps="$steps" '/^Loop time of/ { seconds = $4 } END { printf "%.4f", n * steps / seconds / 1e6 }' "$work/screen"
}
lap_of_diefill() { # bed
  taskset -c "$core" "$diefill" bench "$1" --state "$beds/$1.csv.gz" --steps "$steps" |
    awk '/^sphere_steps_per_second/ { printf "%.4f", $2 / 1e6 }'
}

for bed in $which; do
  spheres=50000
  [ "$bed" = clumps ] && spheres=49000
  python3 "$beds/to_lammps.py" "$bed" "$work/$bed.data"
  echo "$bed: million sphere-steps a second on core $core, $steps steps a lap"
  : >"$work/ratios"
  lap=1
  while [ "$lap" -le "$laps" ]; do
    ours=$(lap_of_diefill "$bed")
    theirs=$(lap_of_lammps "$bed" "$spheres")
    ratio=$(awk -v a="$ours" -v b="$theirs" 'BEGIN { printf "%.3f", a / b }')
    echo "  lap $lap: diefill $ours, LAMMPS $theirs, ratio $ratio"
    echo "$ratio" >>"$work/ratios"
    [ -z "${CSV:-}" ] || echo "$bed,$lap,$ours,$theirs,$ratio" >>"$CSV"
    lap=$((lap + 1))
  done
  sort -n "$work/ratios" | awk -v bed="$bed" '{ r[NR] = $1 }
    END { m = NR % 2 ? r[(NR + 1) / 2] : (r[NR / 2] + r[NR / 2 + 1]) / 2; printf "%s: median ratio %.2f of %d laps\n", bed, m, NR }'
done
