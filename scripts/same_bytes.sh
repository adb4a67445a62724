#!/usr/bin/env bash
# The same bytes from g++ -O3, g++ -O0 with verify() on, and clang++: surfaces, solids, sections and branching
# diagrams of every example, the latter with all samples, surfaces of simplified contours, and a Moebius diagram. Expects build/release; builds the other two. Where it matters: -O3 is where a value-changing
# transformation would show, another compiler is where an unspecified order of evaluation would.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/install.sh

configure_arguments=(-DCROSSLOFT_BUILD_TESTS=OFF)
build dev crossloft_cli
cmake --preset release -B build/clang -DCMAKE_CXX_COMPILER=clang++ "${configure_arguments[@]}"
cmake --build build/clang --target crossloft_cli

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for name in release dev clang; do
  mkdir "$scratch/$name"
  for input in examples/*.contour examples/figures/*.contour examples/topology/*.contour; do
    target=$scratch/$name/$(basename "$input" .contour)
    build/$name/crossloft reconstruct "$input" --quiet -o "$target.ply" --solid "$target.vtu" \
      --dump-sections "$target.contour" >/dev/null
    build/$name/crossloft reconstruct "$input" --quiet --simplify 1e-3 -o "$target.few.ply" >/dev/null
    build/$name/crossloft reconstruct "$input" --quiet --branching all --cutting -o "$target.all.ply" \
      --dump-branching "$target.svg" >/dev/null
  done
  build/$name/crossloft moebius examples/sites.txt -o "$scratch/$name/sites.svg" >/dev/null
done
for name in dev clang; do diff -rq "$scratch/release" "$scratch/$name"; done
echo "same bytes from g++ -O3, g++ -O0 and clang++: $(find "$scratch/release" -type f | wc -l) files each"
