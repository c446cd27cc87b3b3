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

# An ellipsoid with a bump, a few vertices, of which the number decides the proportions.
# Usage: lump NUMBER >FILE.off
lump() {
  awk -v number="$1" 'BEGIN {
    rings = 6; segments = 8; pi = 3.14159265358979
    print "OFF"; print 2 + (rings - 1) * segments, 2 * (rings - 1) * segments, 0
    a = 1 + .07 * number; b = .7 - .04 * number
    print 0, 0, .4
    for (i = 1; i < rings; ++i)
      for (j = 0; j < segments; ++j) {
        t = pi * i / rings; p = 2 * pi * j / segments
        bump = 1 + .25 * exp(-3 * ((t - 1) ^ 2 + (p - 1) ^ 2))
        print a * bump * sin(t) * cos(p), b * bump * sin(t) * sin(p), .4 * bump * cos(t)
      }
    print 0, 0, -.4
    last = 1 + (rings - 1) * segments
    for (j = 0; j < segments; ++j) {
      after = (j + 1) % segments
      print 3, 0, 1 + j, 1 + after
      print 3, last, last - segments + after, last - segments + j
      for (first = 1; first < last - segments; first += segments) {
        print 3, first + j, first + j + segments, first + after + segments
        print 3, first + j, first + after + segments, first + after
      }
    }
  }'
}

# Some small shapes, their pairs in a list, and what one process makes of them.
# Usage: make_pairs SHAPES FOLDER: folder, with shapes/, pairs.csv and alone/
make_pairs() {
  local i j
  mkdir -p "$2/shapes"
  for ((i = 0; i < $1; ++i)); do lump "$i" >"$2/shapes/s$i.off"; done
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
