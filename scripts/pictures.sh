#!/usr/bin/env bash
# pictures.sh [PROGRAM]: draws the pictures of the pages anew.
# examples/topology: link and tunnel are `torus(1, 0.4, 24, 12)` (inspect/solids.h) cut by `slice --random 6 --seed 13`
# and `--random 5 --seed 15`; dome is a disk below a ring, by hand.
set -euo pipefail
cd "$(dirname "$0")/.."
program=${1:-build/release/crossloft}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture NAME OPTION...: docs/NAME.png of examples/topology/*.contour.
picture() {
  "$program" reconstruct "${@:2}" -o "$work/surface.ply" --quiet --picture "docs/$1.png" --picture-size 600 300
}

"$program" demo -o "$work/demo" >"$work/log"
cp "$work/demo/picture.png" docs/demo.png
"$program" moebius examples/sites.txt -o docs/moebius.svg --labels >"$work/log"
picture link examples/topology/link.contour --mode joint --picture-from 0.6 -0.5 0.4 --picture-of -0.9 0.45 0.3 0.45
for mode in joint natural; do
  picture tunnel-$mode examples/topology/tunnel.contour --mode $mode --picture-from -1 -0.2 0.8 --picture-of -0.5 0.2 0.3 0.65
done
picture dome-closed examples/topology/dome.contour --picture-from -0.9 0.4 1.3
picture dome-open examples/topology/dome.contour --picture-from -0.9 0.4 1.3 --dome-confidence 0.5
