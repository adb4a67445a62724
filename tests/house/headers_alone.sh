#!/usr/bin/env bash
# headers_alone.sh COMPILER: every header of the tree compiles as the only include of a file. Run in the root.
set -u
alone() {
  "$1" -std=c++20 -Wall -Wextra -Wpedantic -Werror -fsyntax-only \
    -include "$2" -x c++ /dev/null || { echo "$2 does not compile alone"; return 1; }
}
export -f alone
find geom delaunay arrangement repair moebius prune reconstruct inspect io cli -name '*.h' -print0 |
  sort -z | xargs -0 -P "$(nproc)" -I{} bash -c 'alone "$@"' _ "$1" {}
