#!/usr/bin/env bash
# cli_test.sh PROGRAM SOURCE: what the program promises its caller: exit codes, one message, no half-written file.
set -u
program=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# fail MESSAGE: counts a failure.
fail() { echo "FAILED: $1"; failures=$((failures + 1)); }

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
expect 2 "'reconstuct' is no command; did you mean reconstruct" reconstuct x.contour -o x.ply
expect 2 "'nonsense' is no command" nonsense
expect 2 "'' is no command" ''
expect 2 '' reconstruct --nonsense
expect 2 'unknown extension' reconstruct "$source/examples/demo.contour" -o x.xyz
expect 2 'unknown extension' reconstruct input.txt -o x.ply
expect 2 '' reconstruct "$source/examples/demo.contour" -o x.ply --mode best
expect 2 '' reconstruct "$source/examples/demo.contour" -o x.ply --match-tolerance -1
expect 2 '' slice x.ply -o x.contour --parallel 3 --random 4
expect 0 '^crossloft [0-9]' --version
for command in reconstruct repair info check compare slice moebius delaunay demo; do expect 0 "crossloft $command" $command --help; done

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
grep -q '"report_version": 2' cube.json || { echo "FAILED: report without its version"; failures=$((failures + 1)); }
expect 0 'good' check cube.ply cube.contour

# A stack, slice by slice: the same surface, and only what slices can tell
expect 0 '' reconstruct "$source/examples/demo.contour" -o solid.ply --quiet
expect 0 '40 planes' slice solid.ply -o stack.csl --parallel 40
expect 0 '^surface' reconstruct stack.csl -o at_once.ply
expect 0 'in [2-9] windows' reconstruct stack.csl -o streamed.ply --stream --window 1 --report stream.json
grep -q '"windows": [2-9]' stream.json && grep -q '"genus": [1-9]' stream.json || fail 'the report of a stream'
expect 0 'good' check streamed.ply stack.csl
expect 0 'IoU 1$' compare at_once.ply streamed.ply
expect 2 'not parallel to plane 0' reconstruct "$source/examples/demo.contour" -o no.ply --stream
expect 2 'excludes --stream' reconstruct stack.csl -o no.ply --stream --solid no.vtu
expect 2 'has the extension .stl' reconstruct stack.csl -o no.stl --stream
expect 2 '' reconstruct stack.csl -o no.ply --window 100
expect 2 'all planes at once' reconstruct stack.csl -o no.ply --stream --divide all
head -c 100000 stack.csl >cut.csl
expect 3 '^crossloft: cut.csl:.*the file ends' reconstruct cut.csl -o no.ply --stream --report no.json
absent no.ply no.json no.vtu no.stl

# Repair
expect 0 '^displacement +0 ' repair cube.contour -o same.contour --report same.json
cmp -s cube.contour same.contour || { "$program" repair same.contour -o same2.contour >out.txt; cmp -s same.contour same2.contour; } ||
  fail 'repair changed sections that are good'
grep -q '"repair_version": 1' same.json || fail 'report of a repair without its version'
printf "2\n$(section 1)0 0 1 0 4 4\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n$edges" >bowtie2.contour
expect 3 'crosses itself' reconstruct bowtie2.contour -o bowtie2.ply
expect 0 '^crossings +1 change' repair bowtie2.contour -o clean.contour --report clean.json
grep -q '"kind": "crossings"' clean.json || fail 'a change is not in the report'
expect 0 '^surface' reconstruct clean.contour -o clean.ply
expect 0 '^crossings +1 change' reconstruct bowtie2.contour -o bowtie2.ply --repair --report bowtie2.json
grep -q '"repair": {' bowtie2.json || fail 'the report does not tell of the repair'
printf "2\n$(section 1)0 0 1 0 4 3\n${square//%s/0}0 1 1 0\n1 2 1 0\n2 3 1 0\n" >open2.contour
expect 3 '^crossloft: open2.contour.*not closed' check cube.ply open2.contour
expect 1 '^crossloft: warning: plane 1, contour 0: contour-left-out: the chain of 3 edges' repair open2.contour -o open2_clean.contour
expect 1 '^crossloft: warning: plane 1, contour 0: contour-left-out' reconstruct open2.contour -o open2.ply --repair --quiet
[ -s open2.ply ] || fail 'no surface without the contour that was left out'
expect 0 '^contour-closed' repair open2.contour -o open2_clean.contour --close-gap 1 --limit 1
# A hole as a record of its own, which reconstruct refuses, is a hole.
hole() { printf '0 0 1 %s 4 4\\n.2 .2 %s\\n.8 .2 %s\\n.8 .8 %s\\n.2 .8 %s\\n%s' "-$1" "$1" "$1" "$1" "$1" "$edges"; }
printf "4\n$(section 0)$(hole 0)$(section 1)$(hole 1)" >hole.contour
expect 3 'overlaps that of plane 0' reconstruct hole.contour -o hole.ply
expect 0 'volume 0.64$' reconstruct hole.contour -o hole.ply --repair --mode joint
# One point far away encloses nothing: it says nothing of the size, and the cube stays.
printf "2\n$(section 1)0 0 1 0 5 5\n${square//%s/0}5e6 5e6 0\n${edges}4 4 1 0\n" >far.contour
expect 0 '^no-area +1 change' repair far.contour -o near.contour
expect 0 'volume 1$' reconstruct far.contour -o far.ply --repair
grep -q '^crossloft: warning: plane 1, contour 1: no-area: left out' out.txt || fail 'no word of the point'
expect 2 '' repair cube.contour -o clean.contour --limit 2
expect 2 '' repair cube.contour -o cube.contour
expect 3 'missing.contour' repair missing.contour -o clean.contour

# Where the solid touches itself: moved apart unless told not to, and whole either way
expect 0 '^pinched .*; [1-9][0-9]* copies moved apart' reconstruct "$source/examples/demo.contour" -o apart.ply --report apart.json
grep -q '"separate": true' apart.json || { echo "FAILED: the report does not name separate"; failures=$((failures + 1)); }
expect 0 '^pinched .*; 0 copies moved apart, [1-9][0-9]* left touching' reconstruct "$source/examples/demo.contour" -o touching.ply --keep-touching
expect 0 'good' check apart.ply "$source/examples/demo.contour"
cmp -s apart.ply touching.ply && { echo "FAILED: --keep-touching changes nothing"; failures=$((failures + 1)); }

expect 0 '^pinched .*, 0 left touching' reconstruct "$source/examples/figures/fig18.contour" -o free.ply --separate 1e-3 --report free.json
grep -q '"contacts": 0,' free.json && grep -q '"separation": 0.001,\?$' free.json || fail 'separated figures touch'
expect 1 '^NOT good: sections are missing' check free.ply "$source/examples/figures/fig18.contour"
expect 0 '^good$' check free.ply "$source/examples/figures/fig18.contour" --on-plane 1e-3
expect 2 '' reconstruct "$source/examples/demo.contour" -o free.ply --separate 2

# Flat sections: left out with a warning, or plates
expect 0 'stay bare' reconstruct "$source/examples/figures/fig20b.contour" -o flat.ply --mode joint
expect 0 '^thickened +1 flat region' reconstruct "$source/examples/figures/fig20b.contour" -o plate.ply --mode joint --thicken 1e-3 --report plate.json
grep -q '"thickened_regions": 1,' plate.json && grep -q '"flat_regions": 0,' plate.json || fail 'the report tells of no plate'
expect 0 'good' check plate.ply "$source/examples/figures/fig20b.contour"
expect 2 '' reconstruct "$source/examples/demo.contour" -o plate.ply --thicken -1

expect 0 'IoU 1$' compare cube.ply cube.ply
expect 0 '3 planes' slice cube.ply -o cut.contour --parallel 3
expect 0 'planes +3' info cut.contour
printf '# comment\n0 0 1 -0.5\n\n1 0 0 -0.25\r\n' >planes.txt
expect 0 '2 planes' slice cube.ply -o cut.csl --planes planes.txt
printf '0 0 1 -0.5# half way\r1 0 1e-400 -0.25\r' >planes.txt
expect 0 '2 planes' slice cube.ply -o cut.csl --planes planes.txt
printf '0 0 1\n' >planes.txt
expect 3 'planes.txt:1: expected four' slice cube.ply -o cut2.csl --planes planes.txt
absent cut2.csl
printf '\xEF\xBB\xBF0 0 1 -0.5\n' >planes.contour
expect 0 '1 planes' slice cube.ply -o cut.csl --planes planes.contour
expect 2 'planes.contour: is the input' slice cube.ply -o planes.contour --planes planes.contour
[ "$(grep -c . planes.contour)" = 1 ] || fail 'the list of planes was overwritten'
expect 0 '' reconstruct cube.contour -o quiet.ply --quiet
[ -s out.txt ] && { echo "FAILED: --quiet is not"; cat out.txt; failures=$((failures + 1)); }

# Fewer vertices: off by default, told in summary and report, conforming to the sections it dumps
expect 0 '' reconstruct "$source/examples/demo.contour" -o plain.ply --report plain.json
grep -q simplified out.txt && fail 'simplified without being asked'
grep -q '"simplified_vertices": 0,' plain.json && grep -q '"simplify": 0.0,\?$' plain.json || fail 'not off by default'
expect 0 '^simplified +[1-9][0-9]* contour vertices' reconstruct "$source/examples/demo.contour" -o few.ply \
  --simplify 1e-3 --report few.json --dump-sections few.contour
grep -q '"simplify": 0.001,\?$' few.json && grep -q '"simplified_vertices": [1-9]' few.json || fail 'the report does not tell'
expect 0 'good' check few.ply few.contour
expect 2 '' reconstruct "$source/examples/demo.contour" -o few.ply --simplify -1
expect 2 '' reconstruct "$source/examples/demo.contour" -o few.ply --simplify 2

# The topology of the whole: a hollow tetrahedron; the pictures of prune/README.md
printf 'OFF\n8 8 0\n0 0 0\n9 0 0\n0 9 0\n0 0 9\n1 1 1\n2 1 1\n1 2 1\n1 1 2
3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 5 6\n3 4 7 5\n3 4 6 7\n3 5 7 6\n' >hollow.off
# topology COMPONENTS CAVITIES GENUS SURFACE: what check says of a surface.
topology() {
  expect 0 "^components +$1\$" check "$4"
  grep -Eq "^cavities +$2\$" out.txt && grep -Eq "^genus +$3\$" out.txt ||
    { echo "FAILED: $4 has not $2 cavities, genus $3:"; cat out.txt; failures=$((failures + 1)); }
}
topology 2 1 0 hollow.off
sed 's/^3 \([0-9]\) \([0-9]\) \([0-9]\)$/3 \1 \3 \2/' hollow.off >inverted.off
expect 1 '^inside out +2 components$' check inverted.off
grep -qx 'NOT good: components are inside out' out.txt || fail 'not told that it is inside out'

# What is not good is said
{ printf 'OFF\n8 8 0\n'; for i in 1 2; do printf '0 0 0\n9 0 0\n0 9 0\n0 0 9\n'; done
  printf '3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n'; } >twice.off
expect 1 '^NOT good: triangles overlap in a plane$' check twice.off
echo 'no surface' >none.obj
expect 1 '^NOT good: the surface has no triangles$' check none.obj
expect 1 '^NOT good: the surface has no triangles, sections are missing .1 of their area.$' check none.obj cube.contour
expect 0 'none.obj has no triangles' compare none.obj none.obj
grep -q nan out.txt && fail 'a ratio of nothing'
printf "3\n$(section 0)$(section 1)$(section 5)" >tall.contour
expect 1 '^NOT good: sections are missing .0.333 of their area.$' check cube.ply tall.contour
expect 0 '^good$' check cube.ply tall.contour --max-missing 0.4
expect 1 '^NOT good: .*too far off$' check cube.ply tall.contour --max-missing 1 --max-distance 0.9
expect 2 'on-plane' check cube.ply cube.contour --on-plane nan
expect 2 'on-plane' check cube.ply cube.contour --on-plane 0.2
for limit in distance missing extra; do
  for value in nan -1; do expect 2 'is not a number from 0 to inf' check cube.ply cube.contour --max-$limit $value; done
done

# has FILE KEY:VALUE...: a report says so.
has() {
  local report=$1 pair
  for pair in "${@:2}"; do
    grep -Eq "\"${pair%%:*}\": ${pair#*:},?\$" "$report" || fail "$report does not say $pair"
  done
}
expect 1 '^NOT good' check cube.ply tall.contour --report tall.json
has tall.json check_version:1 good:false genus:0 'missing_share:0\.33.*' distance:null max_distance:null plane:2
expect 0 '^good$' check cube.ply --report alone.json
has alone.json good:true closed:true cavities:0 'volume:1\.0'
grep -q sections alone.json && fail 'a report of sections that were not given'
expect 0 'IoU 1$' compare cube.ply cube.ply --report alike.json
has alike.json compare_version:1 'iou:1\.0' 'hausdorff:0\.0' components:1
expect 0 '' compare cube.ply none.obj --report without.json
has without.json hausdorff:null
expect 2 'json' compare cube.ply cube.ply --report alike.txt
expect 3 'missing' check cube.ply --report missing/r.json
expect 3 '' compare cube.ply nothing.ply --report nothing.json
absent nothing.json

# Needles end where no triangle begins, points of no triangle are far away, sizes are extreme
{ printf 'OFF\n12 16 0\n'
  for z in 0 1; do printf "0 0 $z\n1 0 $z\n1 1 $z\n0 1 $z\n"; done
  printf '0.5 0.5 1\n0.500001 0.5 1\n0.5 0.500001 1\n0.5 0.5 11\n'
  printf '3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n'
  printf '3 8 10 9\n3 8 9 11\n3 9 10 11\n3 10 8 11\n'; } >needle.off
expect 0 '^Hausdorff +10 ' compare cube.ply needle.off
{ printf 'OFF\n5 4 0\n'; printf '%s 0 0\n' 0 1e-110; printf '0 1e-110 0\n0 0 1e-110\n1e14 0 0\n'
  printf '3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n'; } >tiny.off
expect 1 '^inside out +1 components$' check tiny.off
expect 0 '^1 planes, 3 contour edges$' slice tiny.off -o tiny.contour --parallel 1

# One plane in several records is one section
beside='0 0 1 %s 4 4\n3 0 %s\n4 0 %s\n4 1 %s\n3 1 %s\n'
{ printf "4\n$(section 0)$(section 1)"; for z in 0 1; do printf "$beside$edges" "-$z" $z $z $z $z; done; } >records.contour
expect 0 'planes 1 and 3 are one plane' reconstruct records.contour -o records.ply
expect 0 '^good$' check records.ply records.contour
examples=$source/examples/topology
for mode in joint natural; do expect 0 '' reconstruct "$examples/tunnel.contour" -o $mode.ply --mode $mode; done
topology 1 0 2 joint.ply
topology 1 0 1 natural.ply
expect 0 '' reconstruct "$examples/dome.contour" -o closed.ply
expect 0 '' reconstruct "$examples/dome.contour" -o open.ply --dome-confidence 0.5
topology 1 0 0 closed.ply
topology 1 0 1 open.ply
expect 0 '' reconstruct "$examples/link.contour" -o annular.ply --mode joint --report annular.json --picture annular.png \
  --picture-size 64 32 --picture-from 0.6 -0.5 0.4 --picture-of -0.9 0.45 0.3 0.45
grep -q '"vertex_copies": 1,' annular.json && grep -q '"bad_links": 1$' annular.json || fail 'not one annular link'
[ "$(od -An -tx1 -j16 -N8 annular.png | tr -d ' ')" = 0000004000000020 ] || fail 'a picture of another size'
for from in '0 0 1' '1 0 0' '0 -1 -1'; do
  expect 0 '' reconstruct cube.contour -o side.ply --picture side.png --picture-size 32 16 --picture-from $from
done
expect 2 'picture-from' reconstruct cube.contour -o side.ply --picture side.png --picture-from 0 0 0
expect 2 'picture-of' reconstruct cube.contour -o side.ply --picture side.png --picture-of 0 0 1 0
expect 0 'warning: --picture-of: the data are further' reconstruct cube.contour -o side.ply --picture side.png \
  --picture-size 32 16 --picture-of 9 9 9 1

# Options that would change nothing, or contradict each other
for option in '--picture-size 64 32' '--picture-from 1 1 1' '--picture-of 0 0 0 1'; do
  expect 2 'requires --picture' reconstruct cube.contour -o useless.ply $option
done
expect 2 'requires --repair' reconstruct cube.contour -o useless.ply --repair-limit 0.1
expect 2 'excludes --keep-touching' reconstruct cube.contour -o useless.ply --separate 0.1 --keep-touching
for option in --join-confidence --dome-confidence --alone-confidence --cavity-confidence --smooth-weight; do
  expect 2 "$option: is for --mode natural" reconstruct cube.contour -o useless.ply --mode paper $option 0.1
  expect 2 "$option: nan is not a number" reconstruct cube.contour -o useless.ply $option nan
done
for option in --divide --look-around; do
  expect 2 "$option: is for --mode natural" reconstruct cube.contour -o useless.ply --mode joint $option all
done
expect 2 'limit: nan is not a number from 0 to 1' repair cube.contour -o useless.contour --limit nan
expect 2 'direction: is for' slice cube.ply -o useless.contour --random 3 --direction 1 0 0
expect 2 'seed: is for' slice cube.ply -o useless.contour --parallel 3 --seed 1
for seed in -1 1.5 18446744073709551616; do
  expect 2 "seed: $seed is not a whole number" slice cube.ply -o useless.contour --random 3 --seed $seed
done
absent useless.ply useless.contour
expect 0 '1 planes' slice cube.ply -o far.contour --random 1 --seed 18446744073709551615
for length in 1e-300 1e300; do
  expect 0 '2 planes' slice cube.ply -o x.contour --parallel 2 --direction $length 0 0
  expect 0 'directions, 2 with a section' info x.contour
done
printf 'OFF\n0 0 0\n' >nothing.off
expect 3 'nothing.off: the mesh has no triangle' slice nothing.off -o useless.contour --parallel 3

# Whole numbers are decimal
expect 0 '^10 planes' slice cube.ply -o ten.contour --random 010 --seed 010
expect 0 '^10 planes' slice cube.ply -o ten2.contour --random 10 --seed 10
cmp -s ten.contour ten2.contour || fail 'a seed is octal'
for number in 0x10 1e1 -1 100001; do
  expect 2 "random: $number is not a whole number from 1 to 100000" slice cube.ply -o useless.contour --random $number
done
expect 0 '' reconstruct cube.contour -o side.ply --picture side.png --picture-size 0100 064 --threads 02
[ "$(od -An -tx1 -j16 -N8 side.png | tr -d ' ')" = 0000006400000040 ] || fail 'the size of a picture is octal'
expect 2 'threads: 1025 is not a whole number from 0 to 1024' reconstruct cube.contour -o useless.ply --threads 1025
expect 2 'window: 0 is not' reconstruct stack.csl -o useless.ply --stream --window 0

# What has no volume in doubles
huge="$source/tests/io/bad/contour/beyond_1e100.contour"
expect 3 '^crossloft: [^ ]*beyond_1e100.contour:12: plane 1: a coordinate is beyond 1e100$' info "$huge"
expect 3 'beyond_1e100.contour:12: plane 1: a coordinate is beyond 1e100$' check cube.ply "$huge"
tetrahedron() { printf "OFF\n4 4 0\n0 0 0\n$1 0 0\n0 $1 0\n0 0 $1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"; }
for size in 1e160 1e-110; do
  tetrahedron $size >size.off
  expect 1 '^NOT good: components are inside out$' check size.off
done

# Delaunay: the same points as text, surfaces and raw doubles
# value KEY REPORT: what a report says.
value() { sed -n "s/^  \"$1\": \"\?\([^\",]*\)\"\?,\?\$/\1/p" "$2"; }
# is REPORT KEY EXPECTED [KEY EXPECTED]...
is() {
  local report=$1
  shift
  for (( ; $#; )); do
    [ "$(value "$1" "$report")" = "$2" ] || fail "$report has $1 '$(value "$1" "$report")', not '$2'"
    shift 2
  done
}
# double N: the eight bytes of a whole number N >= 0 as a double, the least significant first.
double() {
  local n=$1 e=0 bits=0 i
  if [ "$n" -gt 0 ]; then
    while [ $((n >> (e + 1))) -gt 0 ]; do e=$((e + 1)); done
    bits=$(((e + 1023) << 52 | ((n << (52 - e)) & ((1 << 52) - 1))))
  fi
  for i in 0 8 16 24 32 40 48 56; do printf "\\x$(printf %x $(((bits >> i) & 255)))"; done
}
awk 'BEGIN { r = 7; for (i = 0; i < 60; ++i) { for (k = 0; k < 3; ++k) { r = (r * 1103 + 12345) % 65536
             printf "%d ", int(r / 2048) } print "" } print "31 31 31\n31 31 31" }' >p.txt
points=$(grep -c . p.txt)
{ printf 'OFF\n%d 0 0\n' "$points"; cat p.txt; } >p.off
{ printf 'ply\nformat ascii 1.0\nelement vertex %d\nproperty double x\nproperty double y\nproperty double z\nend_header\n' "$points"
  cat p.txt; } >p.ply
for n in $(cat p.txt); do double "$n"; done >p.f64
cp p.txt p.xyz
for kind in xyz txt off ply f64; do expect 0 "^points +$points\$" delaunay p.$kind -o $kind.mesh --report $kind.json; done
is txt.json delaunay_version 1 file p.txt points "$points" dimension 3 duplicates 1 threads 1
[ "$(value tets txt.json)" -gt 100 ] && [ "$(value peak_rss_kib txt.json)" -gt 1000 ] || fail 'no tets or no memory'
for kind in xyz off ply f64; do
  is $kind.json hash "$(value hash txt.json)"
  cmp -s txt.mesh $kind.mesh || fail "other tetrahedra from $kind"
done
tac p.txt >reversed.txt
expect 0 '^duplicates +1$' delaunay reversed.txt --report reversed.json
is reversed.json tets "$(value tets txt.json)"
[ "$(value hash reversed.json)" != "$(value hash txt.json)" ] || fail 'the hash does not see the numbers'

# The hash as docs/report.md has it. The shift of bash drags the sign along, so its upper bits are cut off.
mix() {
  local z=$1
  z=$(((z ^ ((z >> 30) & ((1 << 34) - 1))) * 0xbf58476d1ce4e5b9))
  z=$(((z ^ ((z >> 27) & ((1 << 37) - 1))) * 0x94d049bb133111eb))
  mixed=$((z ^ ((z >> 31) & ((1 << 33) - 1))))
}
# hash_of MESH SECTION CORNERS
hash_of() {
  local sum=0 hash v
  while read -r -a corners; do
    hash=0
    for v in $(printf '%d\n' "${corners[@]:0:$3}" | sort -n); do mix $((hash + v - 1 + 0x9e3779b97f4a7c15)); hash=$mixed; done
    sum=$((sum + hash))
  done < <(sed "1,/^$2\$/d; /^End/d" "$1" | sed 1d)
  printf %016x $sum
}
is txt.json hash "$(hash_of txt.mesh Tetrahedra 4)"
printf '0 0 0\n1 0 0\n0 1 0\n0 0 1\n' >tet.txt
expect 0 '^hash +7632f01967560332$' delaunay tet.txt

expect 0 '^tets +204$' delaunay "$source/examples/points.txt" -o example.vtu
awk 'BEGIN { srand(5); for (i = 0; i < 50000; ++i) print rand(), rand(), rand() }' >many.txt
expect 0 '' delaunay many.txt -o one.vtu --report one.json --threads 1
expect 0 '' delaunay many.txt -o two.vtu --report two.json --threads 2
cmp -s one.vtu two.vtu || fail 'other bytes with two threads'
is two.json threads 2 hash "$(value hash one.json)"
expect 0 '^seconds .* with 1 thread$' delaunay tet.txt --threads 9
"$program" delaunay many.txt -o many.mesh >/dev/null 2>&1 </dev/null & running=$!
until [ -e .many.mesh.0.tmp ] || ! kill -0 $running 2>/dev/null; do :; done
kill -INT $running 2>/dev/null
wait $running
case $? in 0) ;; 130) absent many.mesh ;; *) fail "interrupted with $?" ;; esac
absent

# Weights: none of them matters if all are equal; a light point is hidden
sed 's/$/ 0/' p.txt >zero.txt
expect 0 '^hidden +0$' delaunay zero.txt --weights -o zero.mesh --report zero.json --threads 2
is zero.json hash "$(value hash txt.json)" tets "$(value tets txt.json)" hidden 0 duplicates 1 threads 1
for n in $(cat zero.txt); do double "$n"; done >zero.f64
expect 0 '' delaunay zero.f64 --weights --report zero2.json
is zero2.json hash "$(value hash txt.json)"
printf '0 0 0 0\n9 0 0 0\n0 9 0 0\n0 0 9 0\n1 1 1 -100\n0 0 0 -1\n9 0 0 0\n' >light.txt
expect 0 '^hidden +2$' delaunay light.txt --weights --report light.json
is light.json points 7 tets 1 hidden 2 duplicates 1

# Lower dimensions
printf '0 0 5\n4 0 5\n4 4 5\n0 4 5\n1 2 5\n0 4 5\n' >plane.txt
printf '3 3 3\n1 1 1\n2 2 2\n' >line.txt
printf '1 2 3\n1 2 3\n' >place.txt
printf '# nothing\n' >nothing.txt
expect 0 '^dimension +2, all points on one plane$' delaunay plane.txt -o plane.mesh --report plane.json
is plane.json dimension 2 tets 0 triangles 4 duplicates 1 hash "$(hash_of plane.mesh Triangles 3)"
expect 0 '^edges +2$' delaunay line.txt -o line.mesh --report line.json
is line.json dimension 1 tets 0 edges 2 duplicates 0 hash "$(hash_of line.mesh Edges 2)"
expect 0 '^vertices +1$' delaunay place.txt -o place.vtu --report place.json
is place.json dimension 0 tets 0 duplicates 1
expect 0 '^dimension +-1, no points$' delaunay nothing.txt -o nothing.vtu --report nothing.json
is nothing.json dimension -1 points 0 tets 0 hash 0000000000000000
: >empty.f64
expect 0 '^points +0$' delaunay empty.f64

# Bad points
# bad_points CODE PATTERN FILE ARGUMENT...: one message, nothing written.
bad_points() {
  expect "$1" "^crossloft: .*$2" delaunay "${@:3}" -o none.vtu --report none.json
  [ "$(grep -c . out.txt)" = 1 ] || { fail "$3: not one message"; cat out.txt; }
  absent none.vtu none.json
}
printf '0 0 0\n1 2\n' >short.txt
bad_points 3 'short.txt:2: 2 numbers' short.txt
bad_points 3 'p.txt:1: 3 numbers' p.txt --weights
bad_points 3 'zero.txt:1: more than 3 numbers' zero.txt
printf '0 0 0\n\n1 nan 2\n' >nan.txt
bad_points 3 'nan.txt:3: the y of a point' nan.txt
printf 'x' | cat p.f64 - >odd.f64
bad_points 3 "odd.f64: has $((24 * points + 1)) bytes, .*the 24 bytes of a point" odd.f64
{ double 1; double 2; printf '\0\0\0\0\0\0\370\177'; } >nan.f64
bad_points 3 'nan.f64: point 0' nan.f64
bad_points 3 'missing.xyz: cannot be read' missing.xyz
printf 'OFF\n2 0 0\n0 0 0\n' >cut.off
bad_points 3 'cut.off' cut.off
bad_points 2 'p.off: has the extension .off' p.off --weights
bad_points 2 'unknown extension' points.csv
expect 2 'unknown extension' delaunay p.txt -o p.stl
expect 2 '' delaunay p.txt --threads -1
ln -s p.txt link.json
expect 2 'link.json: is the input' delaunay p.txt --report link.json
expect 3 'its folder is not there' delaunay p.txt -o no/p.vtu

# Outputs are looked at before the work
mkdir folder.ply
expect 3 '^crossloft: folder.ply: cannot be written: it is a folder$' reconstruct cube.contour -o folder.ply
ln -s asked.ply asked.json
expect 2 '^crossloft: asked.json: is asked for twice' reconstruct cube.contour -o asked.ply --report asked.json
for kind in ply json; do ln -s circle.$kind circle.$kind; done
expect 3 '^crossloft: circle.ply: cannot be written: Too many levels' reconstruct cube.contour -o circle.ply --report circle.json
ln -s no/p.ply dangling.ply
expect 3 '^crossloft: dangling.ply: cannot be written: its folder is not there$' reconstruct cube.contour -o dangling.ply
absent asked.ply
mkdir locked
ln -s ../reached.ply locked/link.ply
mkfifo locked/pipe.ply
chmod 555 locked
expect 0 '' reconstruct cube.contour -o locked/link.ply
cmp -s reached.ply cube.ply && [ -L locked/link.ply ] || fail 'a link out of a folder without permission'
cat locked/pipe.ply >piped.ply & reader=$!
expect 0 '' reconstruct cube.contour -o locked/pipe.ply
wait $reader
cmp -s piped.ply cube.ply || fail 'a pipe in a folder without permission'
if [ "$(id -u)" != 0 ]; then # root may write anywhere
  expect 3 '^crossloft: locked/x.ply: cannot be written: no permission in its folder$' reconstruct cube.contour -o locked/x.ply
fi
chmod 755 locked

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
printf "1\n0 0 1 0 4 8\n${square//%s/0}$edges$edges" >twice.contour
for how in '' --stream; do
  expect 0 '^crossloft: warning: plane 0, contour 0: dropped, it encloses no area' reconstruct twice.contour -o one.ply $how
done
printf '1\n0 0 1 0 0 0\n' >none.contour
expect 0 'mismatch +nothing to compare, since there is no contour' info none.contour
printf "2\n$(section 0)$(section 1 | sed 's/ 1 0\\n/ 2 0\\n/g')" >materials.contour
expect 0 'the sections have 2 materials' reconstruct materials.contour -o materials.ply
[ "$(grep -c materials out.txt)" = 1 ] || fail 'materials are told of twice'
[ -s one.ply ] || { echo "FAILED: no surface for one plane"; failures=$((failures + 1)); }

# A failure leaves an existing target as it was
echo precious >kept.ply
expect 3 '' reconstruct bowtie.contour -o kept.ply
[ "$(cat kept.ply)" = precious ] || { echo "FAILED: target overwritten"; failures=$((failures + 1)); }

# Broken promise
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >triangle.off
expect 1 'closed +NO' check triangle.off
grep -q '^genus *unknown' out.txt || fail 'a genus without a manifold'

# A full disk: one message, the target as it was, no temporary file. A limit on the size of files fails as a full disk does.
# full OUTPUT ARGUMENT...
full() {
  echo precious >"$1"
  (
    ulimit -f 2
    "$program" "${@:2}" >out.txt 2>&1 </dev/null
  )
  local got=$?
  [ $got -eq 3 ] || fail "${*:2}: exit code $got on a full disk"
  [ "$(grep -c '^crossloft: .*cannot be written: File too large$' out.txt)" = 1 ] || { fail "${*:2}: message on a full disk"; cat out.txt; }
  [ "$(cat "$1")" = precious ] || fail "$1 overwritten on a full disk"
  absent
}
demo="$source/examples/demo.contour"
for kind in ply obj off stl; do full full.$kind reconstruct "$demo" --quiet -o full.$kind; done
expect 0 '' reconstruct "$demo" --quiet -o demo.ply --solid demo.vtu
full full.contour slice demo.ply --random 9 -o full.contour
full full.csl slice demo.ply --random 9 -o full.csl
full full.vtu delaunay p.txt -o full.vtu
full full.mesh delaunay p.txt -o full.mesh
full full.svg moebius "$source/examples/sites.txt" -o full.svg
if [ -e /dev/full ]; then
  ln -s /dev/full device.ply
  expect 3 'device.ply: cannot be written: No space left on device' reconstruct "$demo" --quiet -o device.ply
  [ -c device.ply ] || fail 'a device was replaced'
  "$program" info "$demo" >/dev/full 2>out.txt
  [ $? -eq 3 ] && grep -q 'standard output cannot be written' out.txt || { fail 'standard output on a full disk'; cat out.txt; }
fi

# Ctrl-C at any time: exit 130 with the target as it was, or all of the new one
cp demo.ply whole.ply
interrupted=0
for delay in 0 0.01 0.02 0.05 0.1 0.2; do
  echo precious >late.ply
  "$program" reconstruct "$demo" --quiet -o late.ply --solid late.vtu >out.txt 2>&1 </dev/null & running=$!
  sleep $delay
  kill -INT $running 2>/dev/null
  wait $running
  case $? in
    0) cmp -s late.ply whole.ply && cmp -s late.vtu demo.vtu || fail "half-written after Ctrl-C at $delay s" ;;
    130)
      interrupted=$((interrupted + 1))
      # Before the program has its handlers the shell's default ends it without a word.
      [ ! -s out.txt ] || grep -q '^crossloft: interrupted, nothing was written$' out.txt || fail "no word of Ctrl-C at $delay s"
      [ "$(cat late.ply)" = precious ] && [ ! -e late.vtu ] || fail "written after Ctrl-C at $delay s"
      ;;
    *) fail "Ctrl-C at $delay s: exit code not 0 or 130" ;;
  esac
  absent
  rm -f late.vtu
done
[ $interrupted -gt 0 ] || fail 'no run was interrupted'

# While files are written the first signal changes nothing, and the second ends what nobody reads.
mkfifo unread.vtu
for signal in INT TERM; do
  rm -f written.ply
  "$program" reconstruct cube.contour --quiet -o written.ply --solid unread.vtu >out.txt 2>&1 </dev/null & running=$!
  until [ -e written.ply ] || ! kill -0 $running 2>/dev/null; do sleep 0.01; done
  kill -$signal $running
  sleep 0.2
  kill -$signal $running 2>/dev/null || fail "the first SIG$signal ended the writing"
  for _ in {1..100}; do kill -0 $running 2>/dev/null || break; sleep 0.1; done
  kill -KILL $running 2>/dev/null && fail "the second SIG$signal did not end the writing"
  wait $running 2>/dev/null
done

"$program" demo -o interrupted >/dev/null 2>&1 </dev/null & running=$!
kill -INT $running 2>/dev/null
wait $running
case $? in 0 | 130) ;; *) echo "FAILED: interrupted with $?"; failures=$((failures + 1)) ;; esac
( cd interrupted 2>/dev/null && absent )

[ $failures -eq 0 ] && echo "all good"
exit $failures
