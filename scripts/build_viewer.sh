#!/bin/bash
# Bundles the page of `isomatch report` into viewer/dist/index.html, which CMake puts into the
# program. Fetches what it needs; does nothing if the bundle is up to date.
set -euo pipefail
cd "$(dirname "$0")/../viewer"

sources=(src index.html package.json package-lock.json tsconfig.json vite.config.ts)
installed=node_modules/.package-lock.json

is_newer_than_sources() {
  [ -e "$1" ] && [ -z "$(find "${sources[@]}" -newer "$1" -print -quit)" ]
}

command -v npm >/dev/null || ../scripts/install_packages.sh viewer
[ "$installed" -nt package-lock.json ] || npm ci --no-progress </dev/null
is_newer_than_sources dist/index.html || npm run build </dev/null
