# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
# What the tests of this folder share. Needs the variable `isomatch`, the program.
# shellcheck shell=bash disable=SC2154

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# Says so as GoogleTest does, which test.sh counts.
skip() {
  echo "[  SKIPPED ] $1 (0 ms)"
  exit 0
}

# Options that make matches quick.
# shellcheck disable=SC2034
quick=(--no-refinement --no-elastic-judging)

# Some small shapes, their pairs in a list, and what one process makes of them.
# Usage: make_pairs SHAPES FOLDER: folder, with shapes/, pairs.csv and alone/
make_pairs() {
  local i j
  mkdir -p "$2/shapes"
  for ((i = 0; i < $1; ++i)); do
    "$isomatch" synth --vertices 1000 --cut .9 --pose "$i" --seed 2 --quiet \
      -o "$2/shapes/s$i.off" || fail "synth"
  done
  for ((i = 0; i < $1; ++i)); do
    for ((j = 0; j < $1; ++j)); do
      [ "$i" = "$j" ] || echo "shapes/s$i.off,shapes/s$j.off"
    done
  done >"$2/pairs.csv"
  (cd "$2" && "$isomatch" batch pairs.csv -o alone --quiet "${quick[@]}") || fail "batch"
}

# Columns of the table that do not tell when, and without what only the place of a run decides.
rows() { cut -d, -f1-11 "$1"; }

# The same maps and rows in both folders, and nothing unfinished.
# Usage: compare EXPECTED FOUND
compare() {
  local map
  diff <(rows "$1/pairs.csv") <(rows "$2/pairs.csv") || fail "pairs.csv differs"
  for map in "$1"/*/source_to_target.bary.txt "$1"/*/source_to_target.txt "$1"/*/registered.ply; do
    cmp "$map" "$2/${map#"$1"/}" || fail "another map"
  done
  [ -z "$(find "$2" -name '*.unfinished')" ] || fail "something unfinished"
}

# Each pair was matched once, as the logs of the shares tell: there is a line without "(earlier)". Of a
# pair whose process died between its last file and that line there is none; at most so many died.
# Usage: matched_once FOLDER LIST DIED
matched_once() {
  local expected found lines matched
  expected=$(wc -l <"$2")
  lines=$(cat "$1"/batch-*-of-*.log)
  found=$(cut -d: -f1 <<<"$lines" | sort --unique | wc -l)
  [ "$found" = "$expected" ] || fail "$found pairs are in the logs, of $expected"
  matched=$(grep --invert-match '(earlier)$' <<<"$lines" | cut -d: -f1 | sort)
  [ -z "$(uniq --repeated <<<"$matched")" ] || fail "matched twice: $(uniq --repeated <<<"$matched")"
  found=$(wc -l <<<"$matched")
  [ "$found" -ge $((expected - $3)) ] || fail "$found pairs were matched, of $expected"
}
