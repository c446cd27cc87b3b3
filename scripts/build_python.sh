#!/bin/bash
# Builds the Python package for Debian's Python; needs no network once the Debian packages are
# there. The last line says what to put into the environment.
# Usage: scripts/build_python.sh [FOLDER]
#   FOLDER  also put the package there, for example into a virtual environment's site-packages
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_packages.sh build python
scripts/build.sh python

folder=build/python/python
if [ $# -gt 0 ]; then
  mkdir -p "$1"
  cp -r "$folder/isomatch" "$1"
  folder=$1
fi
folder=$(realpath "$folder")
PYTHONPATH=$folder /usr/bin/python3 -c 'import isomatch; print("isomatch", isomatch.__version__)'
echo "export PYTHONPATH=$folder"
