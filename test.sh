#!/bin/bash
# Builds the project and runs all its tests, on Debian 12 from nothing: missing packages are
# installed. The last line is 'N passed, N failed'; besides the tests, the build, the
# documentation and each lint check count as one, and so do the viewer's checks and the glTF
# validator.
# Usage: ./test.sh [--lint] [--preset NAME]
#   --lint    also check formatting and run clang-tidy (always on where CI is set)
#   --preset  a preset of CMakePresets.json, such as asan-ubsan; default dev
set -uo pipefail
cd "$(dirname "$0")"

preset=dev
lint=false
[ "${CI:-false}" = false ] || lint=true
while [ $# -gt 0 ]; do
  case $1 in
    --lint) lint=true ;;
    --preset) preset=${2:?--preset needs a name}; shift ;;
    *) sed -n 's/^# Usage: /usage: /p' "$0" >&2; exit 2 ;;
  esac
  shift
done

passed=0
failed=0

# However the script ends, it says how it went.
finish() {
  local status=$?
  [ "$status" = 0 ] || [ "$failed" -gt 0 ] || failed=1
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ] || exit 1
}
trap finish EXIT

# Runs a command as one check.
check() {
  local name=$1
  shift
  echo "== $name"
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $name" >&2
    return 1
  fi
}

run_tests() {
  local report=build/$preset/test_report.xml
  echo "== tests"
  rm -f "$report"
  ctest --test-dir "build/$preset" --parallel "$(nproc)" --output-on-failure \
    --no-tests=error --output-junit test_report.xml || true
  if [ ! -s "$report" ]; then
    failed=$((failed + 1))
    return
  fi
  local total run skipped
  total=$(grep --count '<testcase ' "$report")
  run=$(grep --count ' status="run"' "$report")
  skipped=$(grep --count '<skipped message="SKIP_' "$report")
  [ "$skipped" = 0 ] || echo "$skipped tests were skipped; they count neither way."
  passed=$((passed + run))
  failed=$((failed + total - run - skipped))
}

test_viewer() {
  check "viewer's tests" npm --prefix viewer test || true
  if [ "$lint" = true ]; then
    check "viewer's formatting and types" npm --prefix viewer run lint || true
  fi
  # Other presets make the program too slow to wait for.
  [ "$preset" = dev ] || return 0
  check "browser" scripts/install_packages.sh browser || return 0
  ISOMATCH_PROGRAM=$PWD/build/$preset/tools/isomatch \
    check "viewer in a browser" npm --prefix viewer run test:browser || true
}

test_gltf() {
  check "glTF validator" scripts/validate_gltf.sh "build/$preset/tools/isomatch" || true
}

sections=(build python test)
[ "$lint" != true ] || sections+=(lint)

check "packages" scripts/install_packages.sh "${sections[@]}" || exit 1
viewer=true
check "viewer" scripts/build_viewer.sh || viewer=false
check "build" scripts/build.sh "$preset" || exit 1
if [ "$lint" = true ]; then
  check "formatting" scripts/lint.sh format || true
  check "clang-tidy" scripts/lint.sh tidy "$preset" || true
fi
run_tests
if [ "$preset" = dev ]; then
  check "documentation" scripts/build_docs.sh "build/$preset/tools/isomatch" || true
fi
if [ "$viewer" = true ]; then test_viewer; fi
test_gltf
