#!/usr/bin/env bash
# headers_alone.sh COMPILER FOLDER...: every header of the folders compiles as the only include of a file.
set -u
compiler=$1
shift
alone() {
  "$1" -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only \
    -include "$2" -x c++ /dev/null || { echo "$2 does not compile alone"; return 1; }
}
export -f alone
find "$@" -name '*.h' -print0 |
  sort -z | xargs -0 -P "$(nproc)" -I{} bash -c 'alone "$@"' _ "$compiler" {}
