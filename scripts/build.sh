#!/bin/bash
# Configures and builds a preset of CMakePresets.json into build/PRESET.
# Usage: scripts/build.sh PRESET
set -euo pipefail
cd "$(dirname "$0")/.."

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake --preset "$1" "${launcher[@]}" >/dev/null
cmake --build "build/$1" --parallel "$(nproc)"
