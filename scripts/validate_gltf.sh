#!/bin/bash
# Lets the Khronos validator judge glTF files of all kinds that the program writes.
# Usage: scripts/validate_gltf.sh PROGRAM
set -euo pipefail
program=$(realpath "${1:?usage: scripts/validate_gltf.sh PROGRAM}")
cd "$(dirname "$0")/../tests/gltf"

command -v npm >/dev/null || ../../scripts/install_packages.sh viewer
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --no-progress </dev/null

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for pose in 1 2; do
  "$program" synth --shape creature --vertices 1000 --pose $pose --seed 2 -o "$work/$pose.off" -q
done
"$program" match "$work/1.off" "$work/2.off" -o "$work/result" -q
# A textured square: a seam in its diagonal, a vertex without a face, a degenerate face.
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 1 1 0' 'v 0 1 0' 'v 9 9 9' 'vt 0 0' 'vt 1 0' 'vt 1 1' \
  'vt 0.5 1' 'vt 0 1' 'f 1/1 2/2 3/3' 'f 1/1 3/4 4/5' 'f 1/1 1/1 2/2' >"$work/textured.obj"
for ending in glb gltf; do
  "$program" convert "$work/1.off" "$work/mesh.$ending"
  "$program" convert "$work/textured.obj" "$work/textured.$ending"
  "$program" convert "$work/result" "$work/result.$ending"
done
node validate.mjs "$work"/*.glb "$work"/*.gltf
