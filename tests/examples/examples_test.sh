#!/bin/bash
# The examples agree with the command line program.
# Usage: examples_test.sh ISOMATCH FOLDER_OF_EXAMPLES WORK_FOLDER
set -euo pipefail
isomatch=$1
examples=$2
mkdir -p "$3"
cd "$3"

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

for pose in 1 2; do
  "$isomatch" synth --vertices 1000 --pose $pose --seed 2 -o pose$pose.off
done

"$examples/example_match" pose1.off pose2.off map.txt registered.ply
"$isomatch" match pose1.off pose2.off -o tracked --quiet
cmp map.txt tracked/source_to_target.txt || fail "match differs from the program's map"
cmp registered.ply tracked/registered.ply || fail "match differs from the program's registration"

"$examples/example_levels" pose1.off pose2.off >levels.txt 2>progress.txt
"$isomatch" match pose1.off pose2.off -o paper --quiet --method paper --levels 3
[ "$(wc -l <levels.txt)" = "$(grep --count '"level"' paper/levels.json)" ] || fail "levels"
grep --quiet '^[0-9]* % [a-z]' progress.txt || fail "progress of levels"

"$examples/example_distances" pose1.off >distances.txt
[ "$(head -1 distances.txt)" = "0 0" ] || fail "distance of a vertex to itself"
[ "$(sort --unique distances.txt | wc -l)" = 10 ] || fail "ten different vertices"

"$isomatch" match pose1.off pose2.off -o inverse --quiet --target-to-source
seq "$(wc -l <inverse/source_to_target.txt)" >labels.txt
"$examples/example_labels" pose1.off pose2.off inverse/target_to_source.bary.txt labels.txt carried.txt
"$isomatch" transfer inverse --labels labels.txt -o by_the_program.txt
cmp carried.txt by_the_program.txt || fail "labels differ from those that the program carries"

for example in match levels distances labels; do
  if "$examples/example_$example" 2>usage.txt; then fail "$example without arguments"; fi
  grep --quiet "^usage: example_$example " usage.txt || fail "usage of $example"
done
if "$examples/example_distances" absent.off 2>error.txt; then fail "a file that is not there"; fi
grep --quiet "^absent.off: " error.txt || fail "error does not name the file"
