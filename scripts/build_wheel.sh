#!/bin/bash
# Makes a wheel of the Python package that needs nothing but numpy and a Linux not older than this
# one: the shared libraries are inside. The last line is the wheel's path.
# Usage: scripts/build_wheel.sh [PYTHON]
#   PYTHON  the Python that it is for, with pip; default /usr/bin/python3
set -euo pipefail
cd "$(dirname "$0")/.."

python=${1:-/usr/bin/python3}
folder=build/wheel

scripts/install_packages.sh build python wheel
scripts/build_viewer.sh
rm -rf "$folder"
mkdir -p "$folder/plain"
"$python" -m pip wheel --no-deps --wheel-dir "$folder/plain" .
echo "$PWD/$folder/$("$python" python/packaging/bundle.py "$folder"/plain/*.whl "$folder")"
