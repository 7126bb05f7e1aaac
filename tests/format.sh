#!/bin/sh
# Checks how sources are written.
#   sh tests/format.sh           every source stands as clang-format sets it
#   sh tests/format.sh tidy      and clang-tidy finds nothing in sources changed since the commit before the last
#   sh tests/format.sh tidy main the same since `main`, uncommitted changes included
# Other versions of clang-format set some lines differently, so only version 14 (Debian 12) judges. clang-tidy needs a
# configured build/ (cmake --preset release).
set -eu
cd "$(dirname "$0")/.."

formatter=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$formatter" ] || ! "$formatter" --version | grep -q 'version 14\.'; then
  echo "format: clang-format 14 is missing; not checked (apt-get install clang-format-14)" >&2
else
  git ls-files '*.h' '*.cpp' '*.c' | xargs "$formatter" --dry-run -Werror || {
    echo "format: set these files with: git ls-files '*.h' '*.cpp' '*.c' | xargs $(basename "$formatter") -i" >&2
    exit 1
  }
fi
[ "${1:-}" = tidy ] || exit 0

base=${2:-HEAD~1}
tidier=$(command -v clang-tidy-14 || command -v clang-tidy || true)
[ -n "$tidier" ] || { echo "format: clang-tidy is missing (apt-get install clang-tidy-14)" >&2; exit 1; }
[ -f build/compile_commands.json ] || {
  echo "format: build/compile_commands.json is missing; run cmake --preset release first" >&2
  exit 1
}
# GCC's flags that clang does not know are passed over. Headers count through the changed sources that include them.
git diff --name-only --diff-filter=d "$base" -- '*.cpp' | while read -r file; do
  grep -q "\"file\": \"$(pwd)/$file\"" build/compile_commands.json && echo "$file"
done | xargs -r -n 1 -P "$(nproc)" "$tidier" -p build --quiet --warnings-as-errors='*' \
  --extra-arg=-Wno-unknown-warning-option
