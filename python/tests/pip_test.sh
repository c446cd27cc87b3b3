#!/bin/bash
# Installs the package with pip into a virtual environment, without a network, and uses it there.
# Usage: pip_test.sh PYTHON SOURCE_FOLDER WORK_FOLDER VERSION HAS_PAGE
set -euo pipefail
python=$1
source=$2
work=$3
version=$4
has_page=$5

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

unset PYTHONPATH
rm -rf "$work"
mkdir -p "$work"
cd "$work"
"$python" -m venv --system-site-packages venv
venv/bin/pip install --no-index "$source" >pip.txt 2>&1 || { cat pip.txt; fail "pip install"; }
PATH=$work/venv/bin:$PATH

pip list >list.txt
grep --quiet "^isomatch  *$version\$" list.txt || fail "pip list"
[ "$(python -c 'import isomatch; print(isomatch.__version__)')" = "$version" ] || fail "__version__"
[ "$(python -m isomatch --version)" = "isomatch $version" ] || fail "python -m isomatch --version"
[ "$(isomatch --version)" = "isomatch $version" ] || fail "isomatch --version"
python -m isomatch --help >help.txt
grep --quiet '^Usage: isomatch' help.txt || fail "--help"

for pose in 1 2; do isomatch synth --vertices 1000 --pose $pose --seed 2 -o pose$pose.off; done
python -m isomatch match pose1.off pose2.off -o result
python -c "
import isomatch
isomatch.match('pose1.off', 'pose2.off').save('result_of_python', report=bool($has_page))"
cmp result/source_to_target.txt result_of_python/source_to_target.txt || fail "Python's map"

status=0
python -m isomatch info missing.off 2>error.txt || status=$?
[ $status = 2 ] || fail "exit code of a missing file: $status"
status=0
timeout --preserve-status --signal INT 1 python -m isomatch synth --vertices 1000000 -o large.off \
  2>error.txt || status=$?
[ $status = 130 ] || fail "exit code of Ctrl-C: $status"
