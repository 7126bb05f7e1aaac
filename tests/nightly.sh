#!/bin/sh
# What takes too long for every change, one part after another; prints one table of parts, results and minutes. A part
# that fails does not stop the others. Logs: out/nightly/<part>.log.
#   sh tests/nightly.sh            all parts
#   sh tests/nightly.sh asan slow  some of them:
# tests         tests/run.sh
# tidy          clang-tidy on sources changed since DIEFILL_SINCE (default: the last commit that is older than a day)
# slow          slow physics checks, on ranks too, and the worked examples
# asan, tsan    all tests under the sanitizers
# package       Debian packages, tried in a minimal system; as root
# race          speed against the program `benchmarks` of an earlier build, which DIEFILL_EARLIER names (default:
#               out/nightly/earlier_benchmarks); fails below 0.9 of its speed. Without one, that of this build is kept
#               there for later nights, and the part is left out.
set -u
cd "$(dirname "$0")/.." || exit 1
logs=out/nightly
mkdir -p "$logs"
left_out=77 # exit code of a part that has nothing to compare with

tidy() {
  since=${DIEFILL_SINCE:-$(git rev-list -1 --before='1 day ago' HEAD)}
  sh app/install_packages.sh clang-format-14 clang-tidy-14 && sh tests/format.sh tidy "${since:-HEAD~1}"
}

package() {
  sh app/install_packages.sh file dpkg-dev debootstrap && sh app/build.sh --target diefill _results &&
    rm -rf build/packages && (cd build && cpack -B packages) && sh app/packaging/try_package.sh "$logs/debian"
}

race() {
  kept=$logs/earlier_benchmarks
  earlier=${DIEFILL_EARLIER:-$kept}
  sh app/build.sh --target benchmarks || return 1
  if [ -x "$earlier" ]; then
    [ "$earlier" != "$kept" ] || echo "earlier build: $(cat "$kept.commit")"
    python3 tests/benchmark/race.py build/bin/benchmarks "$earlier" --at-least 0.9
  elif [ -n "${DIEFILL_EARLIER:-}" ]; then
    echo "race: $earlier is not a program" >&2
    return 1
  else
    cp build/bin/benchmarks "$kept" && git rev-parse HEAD >"$kept.commit" || return 1
    echo "race: there is no earlier build; this one is kept as $kept"
    return "$left_out"
  fi
}

part() {
  case $1 in
    tests) sh tests/run.sh ;;
    slow | asan | tsan) sh tests/run.sh "$1" ;;
    tidy) tidy ;;
    package) package ;;
    race) race ;;
    *) echo "there is no part $1" >&2 && return 2 ;;
  esac
}

failed=0
table=""
[ $# -gt 0 ] || set -- tests tidy slow asan tsan package race
for name in "$@"; do
  began=$(date +%s)
  part "$name" >"$logs/$name.log" 2>&1
  case $? in
    0) result=passed ;;
    "$left_out") result="left out" ;;
    *) result=FAILED failed=1 ;;
  esac
  table="$table$(printf '%-10s %-8s %4d min' "$name" "$result" $((($(date +%s) - began + 30) / 60)))
"
done
printf '%s' "$table"
exit $failed
