#!/bin/sh
# Checks how sources are written.
#   sh tests/format.sh           every source stands as clang-format sets it
#   sh tests/format.sh tidy      and clang-tidy finds nothing in sources changed since the commit before the last
#   sh tests/format.sh tidy main the same since `main`, uncommitted changes included
# Other versions of clang-format set some lines differently, so only version 14 (Debian 12) judges. clang-tidy reads how
# each source is compiled in build/tidy, which is configured for it and never built: there every source stands by itself,
# without precompiled headers. It takes some 15 s of one core for a source, so it is part of tests/nightly.sh and not of
# tests/run.sh.
set -eu
cd "$(dirname "$0")/.."

formatter=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$formatter" ] || ! "$formatter" --version | grep -q 'version 14\.'; then
  echo "format: clang-format 14 is missing; not checked (apt-get install clang-format-14)" >&2
else
  sources=$(git ls-files '*.h' '*.cpp' '*.c')
  [ -n "$sources" ] || { echo "format: git lists no sources here; nothing is checked" >&2; exit 1; }
  echo "$sources" | xargs "$formatter" --dry-run -Werror || {
    echo "format: set these files with: git ls-files '*.h' '*.cpp' '*.c' | xargs $(basename "$formatter") -i" >&2
    exit 1
  }
fi
[ "${1:-}" = tidy ] || exit 0

base=${2:-HEAD~1}
tidier=$(command -v clang-tidy-14 || command -v clang-tidy || true)
[ -n "$tidier" ] || { echo "format: clang-tidy is missing (apt-get install clang-tidy-14)" >&2; exit 1; }
# What CMake does not compile: programs on the installed library, and fuzzers that build_guided.sh compiles.
elsewhere='^(sample_tools/|tests/install/|tests/fuzz/(guided_fuzz|read_in_process|shared_coverage)\.cpp$)'
git rev-parse --quiet --verify "$base^{commit}" >/dev/null || { echo "format: there is no commit $base" >&2; exit 1; }
changed=$({ git diff --name-only --diff-filter=d "$base" -- '*.cpp'
  git ls-files --others --exclude-standard -- '*.cpp'; } | grep -Ev "$elsewhere" | sort -u || true)
[ -n "$changed" ] || { echo "format: no source has changed since $base: clang-tidy has nothing to check"; exit 0; }

tree=build/tidy
mkdir -p "$tree"
configured() {
  cmake --preset release -B "$tree" -DDIEFILL_TOGETHER=OFF -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -DDIEFILL_WARNINGS_AS_ERRORS=OFF "$@" >"$tree/configure.log" 2>&1
}
# What runs on ranks is checked where LAMMPS and MPI are installed.
configured -DDIEFILL_MPI=ON || configured -DDIEFILL_MPI=OFF || { cat "$tree/configure.log" >&2; exit 1; }
unlisted=$(echo "$changed" | while read -r file; do
  grep -qF "\"file\": \"$(pwd)/$file\"" "$tree/compile_commands.json" || echo "$file"
done)
[ -z "$unlisted" ] || {
  echo "format: changed, but not compiled in $tree (see $tree/configure.log for what is left out):" >&2
  echo "$unlisted" >&2
  exit 1
}
# GCC's flags that clang does not know are passed over. Headers count through the changed sources that include them.
echo "$changed" | xargs -n 1 -P "$(nproc)" "$tidier" -p "$tree" --quiet --warnings-as-errors='*' \
  --extra-arg=-Wno-unknown-warning-option
echo "format: clang-tidy finds nothing in $(echo "$changed" | wc -l) sources changed since $base"
