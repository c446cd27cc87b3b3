#!/bin/bash
# Builds a release and matches two poses of a made-up creature, on Debian 12 from nothing: missing
# packages are installed. Ends with the distortion and the error of the result, and where it is.
# Usage: ./demo.sh [VERTICES]
set -euo pipefail
cd "$(dirname "$0")"

vertices=${1:-5000}
folder=build/demo
isomatch=build/release/tools/isomatch

scripts/install_packages.sh build
scripts/build_viewer.sh || echo "No viewer: there will be a picture, but no report." >&2
scripts/build.sh release isomatch_program
mkdir -p "$folder"

"$isomatch" synth --shape creature --vertices "$vertices" --pose 1 --seed 2 -o "$folder/source.off"
"$isomatch" synth --shape creature --vertices "$vertices" --pose 2 --seed 2 -o "$folder/target.off"
"$isomatch" match "$folder/source.off" "$folder/target.off" -o "$folder/result"

echo
"$isomatch" eval "$folder/source.off" "$folder/target.off" "$folder/result/source_to_target.bary.txt" \
  --gt-source "$folder/source.vts" --gt-target "$folder/target.vts" \
  --gt-target-sym "$folder/target.sym.vts"

"$isomatch" render "$folder/result" -o "$folder/picture.png"
report="$folder/picture.png"
if [ -e viewer/dist/index.html ]; then
  "$isomatch" report "$folder/result" --quiet \
    --gt-source "$folder/source.vts" --gt-target "$folder/target.vts"
  report="$folder/result/report.html in a browser, or $report"
fi

echo
echo "To see the map, open $report."
echo "The registered source is $folder/result/registered.ply; --method paper runs the method of the paper."
echo "The pair is in $folder, the correspondence in $folder/result."
