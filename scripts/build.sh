#!/bin/bash
# Configures and builds a preset of CMakePresets.json into build/PRESET.
# Usage: scripts/build.sh PRESET [TARGET...]
set -euo pipefail
cd "$(dirname "$0")/.."

preset=$1
shift
targets=()
[ $# = 0 ] || targets=(--target "$@")
cmake --preset "$preset" >/dev/null
cmake --build "build/$preset" --parallel "$(nproc)" "${targets[@]}"
