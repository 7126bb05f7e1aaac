#!/bin/sh
# What takes too long for every landing, one part after another; prints one table of parts, results and minutes. A part
# that fails does not stop the others. Logs: out/nightly/<part>.log.
#   sh tests/nightly.sh            all parts
#   sh tests/nightly.sh asan slow  some of them: format tests slow gallery asan tsan package races
set -u
cd "$(dirname "$0")/.."
logs=out/nightly
mkdir -p "$logs"

part() {
  case $1 in
    format) sh tests/format.sh ;;
    tests) sh tests/run.sh ;;
    slow | asan | tsan) sh tests/run.sh "$1" ;;
    gallery) sh app/build.sh --target diefill && python3 sample_tools/gallery/gallery.py ;;
    package) sh app/build.sh && (cd build && cpack -B packages) && sh app/packaging/try_package.sh out/nightly/debian ;;
    races) sh app/build.sh --target diefill && build/bin/diefill bench clumps && build/bin/diefill bench spheres ;;
    *) echo "there is no part $1" >&2 && return 2 ;;
  esac
}

failed=0
table=""
for name in ${*:-format tests slow gallery asan tsan package races}; do
  began=$(date +%s)
  if part "$name" >"$logs/$name.log" 2>&1; then result=passed; else result=FAILED failed=1; fi
  table="$table$(printf '%-10s %-8s %4d min' "$name" "$result" $((($(date +%s) - began + 30) / 60)))
"
done
printf '%s' "$table"
exit $failed
