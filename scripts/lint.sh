#!/bin/bash
# Checks the sources' formatting and who includes whom, or runs clang-tidy on those that changed since it last passed,
# which needs a built preset.
# Usage: scripts/lint.sh format | scripts/lint.sh tidy PRESET
set -euo pipefail
cd "$(dirname "$0")/.."

folders=()
for folder in include src results program baselines tools bench examples python tests; do
  [ ! -d "$folder" ] || folders+=("$folder")
done

case ${1:-} in
  format)
    find "${folders[@]}" -name '*.h' -o -name '*.cpp' | sort |
      xargs clang-format --dry-run -Werror
    scripts/check_includes.py
    ;;
  tidy)
    scripts/tidy.py "build/$2"
    ;;
  *)
    echo "usage: scripts/lint.sh format | tidy PRESET" >&2
    exit 2
    ;;
esac
