#!/bin/bash
# Builds the documentation site from docs and the public headers: build/docs/index.html, which opens
# from disk. Whatever Doxygen or Sphinx warns of, and links that lead nowhere, are errors.
# Usage: scripts/build_docs.sh [ISOMATCH]
#   ISOMATCH  the program whose options are shown; without it, a release is built
set -euo pipefail
program=${1:+$(realpath "$1")}
cd "$(dirname "$0")/.."

scripts/install_packages.sh docs
command -v node >/dev/null || scripts/install_packages.sh viewer
if [ -z "$program" ]; then
  scripts/install_packages.sh build
  scripts/build.sh release
  program=build/release/tools/isomatch
fi

work=build/docs_work
rm -rf "$work" build/docs
mkdir -p "$work"
(cat docs/site/Doxyfile && echo "OUTPUT_DIRECTORY = $work") | doxygen -
docs/site/collect_pages.py "$program" "$work/pages"
sphinx-build -q -W --keep-going -n -c docs/site -d "$work/doctrees" "$work/pages" build/docs
docs/site/check_links.py build/docs
echo "The documentation is in build/docs/index.html."
