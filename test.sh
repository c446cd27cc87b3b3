#!/bin/bash
# Builds the project and runs all its tests, on Debian 12 from nothing: missing packages are
# installed. The last line is 'N passed, N failed'; besides the tests, the build, the
# documentation and each lint check count as one, and so do the viewer's checks and the glTF
# validator. Tests of the library and the program count by suites.
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
logs=build/checks
names=()
processes=()

# However the script ends, it says how it went.
finish() {
  local status=$?
  [ "$status" = 0 ] || [ "$failed" -gt 0 ] || failed=1
  echo "$passed passed, $failed failed"
  [ "$failed" = 0 ] || exit 1
}
trap finish EXIT

# Counts a check that ended with a status.
count() {
  if [ "$2" = 0 ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $1" >&2
    return 1
  fi
}

# Runs a command as one check.
check() {
  local name=$1 begun=$SECONDS status=0
  shift
  echo "== $name"
  "$@" || status=$?
  echo "-- $name: $((SECONDS - begun)) s"
  count "$name" "$status"
}

# Begins a check beside what follows; `conclude` waits for all of them.
begin() {
  local name=$1
  shift
  names+=("$name")
  "$@" >"$logs/$name.log" 2>&1 </dev/null &
  processes+=($!)
}

conclude() {
  local i status
  for i in "${!processes[@]}"; do
    status=0
    wait "${processes[i]}" || status=$?
    echo "== ${names[i]}"
    [ "$status" = 0 ] || cat "$logs/${names[i]}.log"
    count "${names[i]}" "$status" || true
  done
  names=()
  processes=()
}

run_tests() {
  local report=build/$preset/test_report.xml begun=$SECONDS
  echo "== tests"
  rm -f "$report"
  ctest --test-dir "build/$preset" --parallel "$(nproc)" --output-on-failure \
    --no-tests=error --output-junit test_report.xml || true
  echo "-- tests: $((SECONDS - begun)) s"
  if [ ! -s "$report" ]; then
    failed=$((failed + 1))
    return
  fi
  local total run skipped
  total=$(grep --count '<testcase ' "$report")
  run=$(grep --count ' status="run"' "$report")
  skipped=$(grep --count '^\[  SKIPPED \].* ms)$' "$report")
  [ "$skipped" = 0 ] || echo "$skipped cases were skipped."
  passed=$((passed + run))
  failed=$((failed + total - run))
}

program=$PWD/build/$preset/tools/isomatch
sections=(build python wheel test)
[ "$lint" != true ] || sections+=(lint)
# Other presets make the program too slow for what only waits for it.
[ "$preset" != dev ] || sections+=(browser docs)
if [ "$preset" = tsan ]; then
  sections+=(tsan)
  # What libomp itself does is known from what it tells; libraries of the system are not looked into.
  export TSAN_OPTIONS=ignore_noninstrumented_modules=1
fi

mkdir -p "$logs"
check "packages" scripts/install_packages.sh "${sections[@]}" || exit 1
scripts/install_packages.sh cluster ||
  echo "Without these packages tests of batches on clusters are skipped." >&2
viewer=true
check "viewer" scripts/build_viewer.sh || viewer=false
if [ "$lint" = true ]; then begin "formatting" scripts/lint.sh format; fi
if [ "$viewer" = true ]; then begin "viewer's tests" npm --prefix viewer test; fi
if [ "$viewer" = true ] && [ "$lint" = true ]; then
  begin "viewer's formatting and types" npm --prefix viewer run lint
fi
check "build" scripts/build.sh "$preset" || exit 1
conclude
if [ "$preset" = dev ]; then begin "demo" ./demo.sh; fi
begin "glTF validator" scripts/validate_gltf.sh "$program"
if [ "$preset" = dev ]; then
  begin "documentation" scripts/build_docs.sh "$program"
fi
if [ "$lint" = true ]; then check "clang-tidy" scripts/lint.sh tidy "$preset" || true; fi
conclude
# Alone, since its tests say how long a page takes.
if [ "$preset" = dev ] && [ "$viewer" = true ]; then
  ISOMATCH_PROGRAM=$program check "viewer in a browser" npm --prefix viewer run test:browser || true
fi
run_tests
