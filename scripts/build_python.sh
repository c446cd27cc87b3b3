#!/bin/bash
# Builds the Python package for Debian's Python without installing it, beside the release; needs no
# network once the Debian packages are there. The last line says what to put into the environment.
# Usage: scripts/build_python.sh
set -euo pipefail
cd "$(dirname "$0")/.."

python=/usr/bin/python3
folder=$PWD/build/release/python

scripts/install_packages.sh build python
echo "Building: three minutes at first, one after ./demo.sh, else seconds."
cmake --preset release -DISOMATCH_BUILD_PYTHON=ON -DPython_EXECUTABLE=$python >/dev/null
scripts/build.sh release isomatch_python_package

PYTHONPATH=$folder $python -c 'import isomatch; print("isomatch", isomatch.__version__)'
echo "Only for $python; \`pip install .\` makes it for other Pythons."
echo "export PYTHONPATH=$folder"
