#!/bin/sh
# Races diefill against LAMMPS on settled beds: the same state and contact law, double precision, one pinned core, in
# turns, because machines are noisy. Prints every measurement and the median of their ratios.
#
#   sh tests/benchmark/against_lammps.sh BEDS ["RACE ..."] [LAPS] [STEPS]
#
# RACE: clumps, spheres (law of Bierwisch 2009), hertz-mindlin, jkr (spheres under laws composed of parts).
# BEDS: folder with clumps.csv.gz, spheres.csv.gz, to_lammps.py and lammps/in.clumps, lammps/in.spheres.
# Environment: DIEFILL (program, default build/bin/diefill), CORE (default 0), CSV (file that measurements are added to).
# What differs between the codes: diefill also keeps energy accounts and deepest overlaps in every step, chooses its own
# skin, and turns clumps by forces at the contact point (half the overlap inside the surface), LAMMPS at the surface.
set -eu

[ $# -ge 1 ] || { sed -n '2,11s/^# \{0,1\}//p' "$0" >&2; exit 2; }
beds=$1
which=${2:-clumps spheres hertz-mindlin jkr}
repeats=${3:-7}
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

# The bed of a race, its law, and the normal force in LAMMPS' granular style (E = 2 (1 - 0.3^2) 1e7 Pa).
bed_of() { case $1 in clumps) echo clumps ;; *) echo spheres ;; esac; }
law_of() { case $1 in hertz-mindlin | jkr) echo "$1" ;; *) echo bierwisch ;; esac; }
normal_of() { case $1 in jkr) echo "jkr 1.82e7 0.5 0.3 0.005" ;; *) echo "hertz/material 1.82e7 0.5 0.3" ;; esac; }

# Million sphere-steps a second of one run of each.
speed_of_lammps() { # race spheres
  case $1 in
    hertz-mindlin | jkr) folder=$here/tests/benchmark/laws input=in.spheres ;;
    *) folder=$beds/lammps input=in.$1 ;;
  esac
  (cd "$folder" && OMP_NUM_THREADS=1 taskset -c "$core" lmp -in "$input" -var data "$work/$(bed_of "$1").data" \
    -var normal "$(normal_of "$1")" -var steps "$steps" -log none -screen "$work/screen" >/dev/null)
  awk -v n="$2" -v steps="$steps" '/^Loop time of/ { seconds = $4 } END { printf "%.4f", n * steps / seconds / 1e6 }' "$work/screen"
}
speed_of_diefill() { # race
  taskset -c "$core" "$diefill" bench "$(bed_of "$1")" --law "$(law_of "$1")" --state "$beds/$(bed_of "$1").csv.gz" \
    --steps "$steps" | awk '/^sphere_steps_per_second/ { printf "%.4f", $2 / 1e6 }'
}

for race in $which; do
  spheres=50000
  [ "$race" = clumps ] && spheres=49000
  python3 "$beds/to_lammps.py" "$(bed_of "$race")" "$work/$(bed_of "$race").data"
  echo "$race: million sphere-steps a second on core $core, $steps steps a measurement"
  : >"$work/ratios"
  repeat=1
  while [ "$repeat" -le "$repeats" ]; do
    ours=$(speed_of_diefill "$race")
    theirs=$(speed_of_lammps "$race" "$spheres")
    ratio=$(awk -v a="$ours" -v b="$theirs" 'BEGIN { printf "%.3f", a / b }')
    echo "  repeat $repeat: diefill $ours, LAMMPS $theirs, ratio $ratio"
    echo "$ratio" >>"$work/ratios"
    [ -z "${CSV:-}" ] || echo "$race,$repeat,$ours,$theirs,$ratio" >>"$CSV"
    repeat=$((repeat + 1))
  done
  sort -n "$work/ratios" | awk -v race="$race" '{ r[NR] = $1 }
    END { m = NR % 2 ? r[(NR + 1) / 2] : (r[NR / 2] + r[NR / 2 + 1]) / 2; printf "%s: median ratio %.2f of %d repeats\n", race, m, NR }'
done
