#!/usr/bin/env bash
# Installs what the tests need, builds everything, runs the tests labelled unit and cgal.
#   --slow      also the tests labelled slow
#   --sanitize  also the unit tests under ASan + UBSan and under TSan
#   --clang     also: clang and -O0 builds, and the bytes they write must be those of g++ -O3
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/install.sh

slow=no sanitize=no clang=no
for argument in "$@"; do
  case $argument in
    --slow) slow=yes ;;
    --sanitize) sanitize=yes ;;
    --clang) clang=yes ;;
    *) sed -n '2,5s/^# \{0,1\}//p' scripts/test.sh; exit 2 ;;
  esac
done

install_missing $program_packages $test_packages
if [ $clang = yes ]; then install_missing clang; fi
configure_arguments=(-DCROSSLOFT_BUILD_TESTS=ON)
build release
jobs=$(nproc)
ctest --preset release -j "$jobs"
if [ $slow = yes ]; then ctest --preset slow -j "$jobs"; fi
if [ $sanitize = yes ]; then
  for preset in asan tsan; do build $preset; ctest --preset $preset -j "$jobs"; done
fi
if [ $clang = yes ]; then scripts/same_bytes.sh; fi
