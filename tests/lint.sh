#!/bin/sh
# Checks scripts: shellcheck on those of the shell, pyflakes on Python. A checker that is not installed is named.
#   sh tests/lint.sh
# C++ is checked by the compiler's warnings, which are errors, by tests/project, and by clang-tidy (tests/format.sh
# tidy).
set -eu
cd "$(dirname "$0")/.."

# check CHECKER PACKAGE PATTERN...: runs CHECKER over the files that git lists.
check() {
  checker=$1 package=$2
  shift 2
  if ! command -v "${checker%% *}" >/dev/null; then
    echo "lint: ${checker%% *} is missing; not checked (apt-get install $package)" >&2
    return 0
  fi
  files=$(git ls-files "$@")
  [ -n "$files" ] || { echo "lint: git lists no files here that match: $*" >&2; return 1; }
  # shellcheck disable=SC2086
  echo "$files" | xargs $checker
}

check 'shellcheck --severity=warning' shellcheck '*.sh' .ci/run
check pyflakes3 pyflakes3 '*.py'
