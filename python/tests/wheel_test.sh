#!/bin/bash
# Makes the wheel that has its libraries inside, and looks whether it takes them from there.
# Usage: wheel_test.sh PYTHON SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
python=$1
source=$2
work=$3

rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$source/scripts/build_wheel.sh" "$python" >build.txt 2>&1 || { cat build.txt; exit 1; }
"$python" -m zipfile -e "$(tail -n 1 build.txt)" package
chmod +x package/isomatch/bin/isomatch

system='linux-vdso|ld-linux[^ ]*|lib(c|m|gcc_s|stdc\+\+)'
for binary in package/isomatch/_core*.so package/isomatch/bin/isomatch package/isomatch.libs/*; do
  ldd "$binary" >libraries.txt
  if grep --invert-match --extended-regexp "/isomatch\.libs/|($system)\.so" libraries.txt; then
    echo "FAILED: $binary takes that from elsewhere" >&2
    exit 1
  fi
done

export PYTHONPATH=$work/package
"$python" -m isomatch synth --vertices 1000 -o shape.glb
"$python" -c "import isomatch; assert len(isomatch.read_mesh('shape.glb')[0]) > 900"
