#!/usr/bin/env bash
# consumer.sh subdirectory|package SOURCE BUILD COMPILER: a foreign project builds against the library and runs.
set -euo pipefail
way=$1 source=$2 build=$3 compiler=$4
work=$build/consumer-$way
rm -rf "$work"
if [ "$way" = package ]; then
  cmake --install "$build" --prefix "$work/prefix" >/dev/null
  where=-DCMAKE_PREFIX_PATH=$work/prefix
  "$source/tests/house/headers_alone.sh" "$compiler" "$work/prefix/include/crossloft"
else
  where=-DCROSSLOFT_FOLDER=$source
fi
cmake -G Ninja -S "$source/tests/house/consumer" -B "$work/build" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release "$where"
cmake --build "$work/build"
"$work/build/consumer" "$source/examples/demo.contour" "$work/demo.ply"
[ -s "$work/demo.ply" ]
if [ "$way" = package ]; then "$work/prefix/bin/crossloft" --version; fi
