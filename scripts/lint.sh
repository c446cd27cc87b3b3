#!/bin/bash
# Checks the sources' formatting, or runs clang-tidy on them, which needs a built preset.
# Usage: scripts/lint.sh format | scripts/lint.sh tidy PRESET
set -euo pipefail
cd "$(dirname "$0")/.."

folders=()
for folder in include src baselines tools bench examples python tests; do
  [ ! -d "$folder" ] || folders+=("$folder")
done

case ${1:-} in
  format)
    find "${folders[@]}" -name '*.h' -o -name '*.cpp' | sort |
      xargs clang-format --dry-run -Werror
    ;;
  tidy)
    # Clang does not accept this version of CGAL's headers; consumers are projects of their own.
    left_out='^tests/oracle/exact_geodesics.cpp$\|^tests/consumer/'
    # Headers are checked with the sources that include them. The compiler's own warnings are the
    # build's business, and clang does not find g++'s omp.h. The count of suppressed warnings from
    # system headers is noise.
    find "${folders[@]}" -name '*.cpp' | sort | grep --invert-match "$left_out" |
      xargs --max-args=1 --max-procs="$(nproc)" clang-tidy-19 --quiet -p "build/$2" \
        --extra-arg=-w --extra-arg=-fno-openmp \
        2> >(grep --invert-match 'warnings\? generated' >&2)
    ;;
  *)
    echo "usage: scripts/lint.sh format | tidy PRESET" >&2
    exit 2
    ;;
esac
