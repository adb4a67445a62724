#!/usr/bin/env bash
# fuzz.sh [SECONDS [TARGET...]]: builds the fuzz targets (tests/fuzz/README.md) with clang and runs each for SECONDS, 60 if not
# given. What grows between runs stays in build/fuzz-corpus; a finding is kept in build/fuzz-finds, the exit code is 1.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/install.sh

seconds=${1:-60}
shift $(($# > 0 ? 1 : 0))
targets=("$@")
[ ${#targets[@]} -ne 0 ] || targets=(pipeline contour csl ply obj off stl medit vtu points weighted sites planes)
install_missing $program_packages clang libclang-rt-14-dev
configure_arguments=()
build fuzz

# dictionary TARGET: words of its format.
dictionary() {
  case $1 in
    contour | csl) echo tests/fuzz/sections.dict ;;
    points | weighted | sites | planes) echo tests/fuzz/numbers.dict ;;
    *) echo tests/fuzz/meshes.dict ;;
  esac
}

found=0
mkdir -p build/fuzz-finds
for target in "${targets[@]}"; do
  mkdir -p "build/fuzz-corpus/$target"
  options=(-max_total_time="$seconds" -timeout=30 -rss_limit_mb=2048 -print_final_stats=1
           -artifact_prefix="build/fuzz-finds/$target-")
  case $target in
    pipeline) options+=(-max_len=200 -len_control=0 -entropic=0) ;;  # its many features cost more than the judge
    *) options+=(-max_len=4096 -dict="$(dictionary "$target")") ;;
  esac
  echo "== $target, $seconds s"
  log=build/fuzz-finds/$target.log
  if "build/fuzz/tests/fuzz/fuzz_$target" "${options[@]}" "build/fuzz-corpus/$target" "tests/fuzz/seeds/$target" \
      >"$log" 2>&1; then
    grep -E 'number_of_executed_units|cov:' "$log" | tail -n 2
  else
    found=1
    tail -n 30 "$log"
  fi
done
exit $found
