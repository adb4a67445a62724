#!/usr/bin/env bash
# cli_test.sh PROGRAM SOURCE: what the program promises its caller: exit codes, one message, no half-written file.
set -u
program=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# expect CODE PATTERN ARGUMENT...: runs the program; checks its exit code and that its output matches.
expect() {
  local code=$1 pattern=$2 got
  shift 2
  "$program" "$@" >out.txt 2>&1 </dev/null
  got=$?
  if [ $got -ne "$code" ] || { [ -n "$pattern" ] && ! grep -Eq -- "$pattern" out.txt; }; then
    echo "FAILED: crossloft $*: exit code $got, expected $code and /$pattern/ in:"
    sed 's/^/  /' out.txt
    failures=$((failures + 1))
  fi
}

# absent FILE...: none of them was left behind, nor anything half-written.
absent() {
  local leftover
  for leftover in "$@" .*.tmp; do
    [ -e "$leftover" ] || continue
    echo "FAILED: $leftover was left behind"
    failures=$((failures + 1))
  done
}

# bad NAME PATTERN TEXT: the text as a .contour file is refused with one line and no output file.
bad() {
  printf '%b' "$3" >"$1.contour"
  expect 3 "^crossloft: $1.contour.*$2" reconstruct "$1.contour" -o bad.ply --solid bad.vtu --report bad.json
  [ "$(grep -vc warning out.txt)" = 1 ] || { echo "FAILED: $1: not one message"; cat out.txt; failures=$((failures + 1)); }
  absent bad.ply bad.vtu bad.json
}

square='0 0 %s\n1 0 %s\n1 1 %s\n0 1 %s\n'
edges='0 1 1 0\n1 2 1 0\n2 3 1 0\n3 0 1 0\n'
section() { printf '0 0 1 %s 4 4\\n%s%s' "-$1" "${square//%s/$1}" "$edges"; }

# Usage
expect 2 'subcommand is required'
expect 2 '' nonsense
expect 2 '' reconstruct --nonsense
expect 2 'unknown extension' reconstruct "$source/examples/demo.contour" -o x.xyz
expect 2 'unknown extension' reconstruct input.txt -o x.ply
expect 2 '' reconstruct "$source/examples/demo.contour" -o x.ply --mode best
expect 2 '' reconstruct "$source/examples/demo.contour" -o x.ply --match-tolerance -1
expect 2 '' slice x.ply -o x.contour --parallel 3 --random 4
expect 0 '^crossloft [0-9]' --version
for command in reconstruct info check compare slice moebius demo; do expect 0 "crossloft $command" $command --help; done

# Bad files
expect 3 'missing.contour' reconstruct missing.contour -o x.ply
bad empty . ''
bad truncated . '2\n0 0 1 0 4 4\n0 0 0\n1 0 0\n'
bad counts . '1\n0 0 1 0 -4 4\n'
bad nan . "1\n0 0 1 0 4 4\nnan 0 0\n1 0 0\n1 1 0\n0 1 0\n$edges"
bad index . "1\n0 0 1 0 4 4\n${square//%s/0}0 1 1 0\n1 2 1 0\n2 9 1 0\n3 0 1 0\n"
bad open . "1\n0 0 1 0 4 3\n${square//%s/0}0 1 1 0\n1 2 1 0\n2 3 1 0\n"
bad normal . "1\n0 0 0 0 4 4\n${square//%s/0}$edges"
bad bowtie . "1\n0 0 1 0 4 4\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n$edges"
bad off_plane . "1\n0 0 1 0 4 4\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n$edges"
bad no_plane . '0\n'

# The main job
printf "2\n$(section 0)$(section 1)" >cube.contour
expect 0 '^volume|volume 1$' reconstruct cube.contour -o cube.ply --solid cube.vtu --report cube.json --dump-sections cube2.contour
for file in cube.ply cube.vtu cube.json cube2.contour; do [ -s $file ] || { echo "FAILED: no $file"; failures=$((failures + 1)); }; done
grep -q '"report_version": 1' cube.json || { echo "FAILED: report without its version"; failures=$((failures + 1)); }
expect 0 'good' check cube.ply cube.contour
expect 0 'IoU 1$' compare cube.ply cube.ply
expect 0 '3 planes' slice cube.ply -o cut.contour --parallel 3
expect 0 'planes +3' info cut.contour
printf '# comment\n0 0 1 -0.5\n\n1 0 0 -0.25\r\n' >planes.txt
expect 0 '2 planes' slice cube.ply -o cut.csl --planes planes.txt
printf '0 0 1\n' >planes.txt
expect 3 'planes.txt:1: expected four' slice cube.ply -o cut2.csl --planes planes.txt
absent cut2.csl
expect 0 '' reconstruct cube.contour -o quiet.ply --quiet
[ -s out.txt ] && { echo "FAILED: --quiet is not"; cat out.txt; failures=$((failures + 1)); }

# Moebius diagrams: a disc in the plane of the others, a hidden site
printf '# x y lambda mu\n0 0 4\n3 0\n3 0 1 -1\n' >sites.txt
expect 0 'arcs +1, 1 of them whole' moebius sites.txt -o d.svg --json d.json
grep -Eq 'sites +3, 1 without a cell' out.txt && grep -Eq 'cells +2, 0 disconnected, 1 with holes' out.txt ||
  { echo "FAILED: counts of cells"; cat out.txt; failures=$((failures + 1)); }
grep -q '<circle [^>]*data-arc="0"' d.svg || { echo "FAILED: no circle in d.svg"; failures=$((failures + 1)); }
grep -q '"centre":\[-1.0,0.0\],"radius":2.0' d.json || { echo "FAILED: no circle in d.json"; cat d.json; failures=$((failures + 1)); }
expect 0 '' moebius sites.txt -o d2.svg --box -4,-3,2,3 --width 200 --labels --no-sites
grep -q 'width="200" height="200"' d2.svg || { echo "FAILED: not the page asked for"; failures=$((failures + 1)); }
expect 0 '^cells +16, 2 disconnected, 2 with holes' moebius "$source/examples/sites.txt" -o example.svg
cp example.svg first.svg
expect 0 '' moebius "$source/examples/sites.txt" -o example.svg
cmp -s example.svg first.svg || { echo "FAILED: other bytes the second time"; failures=$((failures + 1)); }
expect 2 'the box to draw' moebius sites.txt -o d3.svg --box 0,0,0,1
expect 2 '' moebius sites.txt -o d3.svg --box 0,0,1
expect 2 'unknown extension' moebius sites.txt -o d3.png
expect 2 'sites.svg: is the input' moebius sites.svg -o sites.svg
expect 3 'missing.txt' moebius missing.txt -o d3.svg
printf '0 0\n1 x\n' >bad_sites.txt
expect 3 'bad_sites.txt:2: .x. stands where the y of a site' moebius bad_sites.txt -o d3.svg
: >no_sites.txt
expect 3 'no_sites.txt.*no site' moebius no_sites.txt -o d3.svg
absent d3.svg

# Branching: drawings, their names, their folder
figure="$source/examples/figures/fig17.contour"
expect 0 'branching +7 samples on 1 faces' reconstruct "$figure" -o b.ply --dump-branching drawings/new --report b.json
expect 0 'drawings +1 in drawings/new' reconstruct "$figure" -o b.ply --dump-branching drawings/new
grep -q '<title>plane 0, face [0-9]*, seen from above: [0-9]* arcs, 7 samples</title>' drawings/new/plane0-face*-above.svg ||
  { echo "FAILED: no drawing of the branching diagram"; failures=$((failures + 1)); }
grep -q '"branching": "auto"' b.json || { echo "FAILED: the report does not name the branching"; failures=$((failures + 1)); }
expect 0 'branching +0 samples' reconstruct "$figure" -o b.ply --branching off
expect 0 '' reconstruct "$figure" -o b.ply --branching all --cutting
expect 2 'not in' reconstruct "$figure" -o b.ply --branching some
expect 2 'names no folder' reconstruct "$figure" -o b.ply --dump-branching ''
expect 3 'b.ply: cannot be written: it is not a folder' reconstruct "$figure" -o c.ply --dump-branching b.ply
absent c.ply

# Nothing to join: empty surface, told why
printf "1\n$(section 0)" >one.contour
expect 0 'warning' reconstruct one.contour -o one.ply
[ -s one.ply ] || { echo "FAILED: no surface for one plane"; failures=$((failures + 1)); }

# A failure leaves an existing target as it was
echo precious >kept.ply
expect 3 '' reconstruct bowtie.contour -o kept.ply
[ "$(cat kept.ply)" = precious ] || { echo "FAILED: target overwritten"; failures=$((failures + 1)); }

# Broken promise
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >triangle.off
expect 1 'closed +NO' check triangle.off

# Ctrl-C: exit 130 or finished before, and nothing half-written
"$program" demo -o interrupted >/dev/null 2>&1 </dev/null & running=$!
kill -INT $running 2>/dev/null
wait $running
case $? in 0 | 130) ;; *) echo "FAILED: interrupted with $?"; failures=$((failures + 1)) ;; esac
( cd interrupted 2>/dev/null && absent )

[ $failures -eq 0 ] && echo "all good"
exit $failures
