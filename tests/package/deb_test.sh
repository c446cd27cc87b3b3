#!/bin/bash
# Makes the Debian packages, unpacks them somewhere else and uses what is in them.
# Usage: deb_test.sh BUILD_FOLDER WORK_FOLDER VERSION HAS_PAGE [PYTHON]
set -euo pipefail
build=$1
work=$2
version=$3
has_page=$4
python=${5:-}

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

rm -rf "$work"
mkdir -p "$work"
cd "$work"
cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/packages" >cpack.txt || fail "cpack"

field() { dpkg-deb --field packages/"$1"_"$version"_*.deb "$2"; }
[ "$(field isomatch Version)" = "$version" ] || fail "version of the package"
field isomatch Depends | grep --quiet 'libfmt' || fail "the program's package names no libfmt"
field libisomatch-dev Depends | grep --quiet 'libeigen3-dev' || fail "dependencies of the library"

for package in isomatch libisomatch-dev; do
  dpkg-deb -x packages/"$package"_"$version"_*.deb root
done
for file in lib/libisomatch.a lib/pkgconfig/isomatch.pc lib/cmake/isomatch/isomatch-config.cmake \
  include/isomatch/version.h include/isomatch/methods/tracked.h share/doc/isomatch/LICENSE \
  share/isomatch/array.sbatch; do
  [ -s "root/usr/$file" ] || fail "no $file"
done
strip --strip-debug root/usr/lib/libisomatch.a root/usr/bin/isomatch  # Lines of sources may.
if grep --recursive --quiet --fixed-strings "$build" root/usr; then fail "names the build folder"; fi

isomatch=root/usr/bin/isomatch
[ "$("$isomatch" --version)" = "isomatch $version" ] || fail "--version"
for pose in 1 2; do "$isomatch" synth --vertices 1000 --pose $pose --seed 2 -o pose$pose.off; done
"$isomatch" match pose1.off pose2.off -o result
[ "$(wc -l <result/source_to_target.txt)" = "$("$isomatch" info pose1.off --json |
  grep --max-count=1 '"vertices"' | tr --complement --delete '0-9')" ] || fail "length of the map"
if [ "$has_page" = 1 ]; then
  "$isomatch" report result --quiet
  grep --quiet 'id="isomatch-manifest">{' result/report.html || fail "page without data"
fi
if [ -n "$python" ]; then
  dpkg-deb -x packages/python3-isomatch_"$version"_*.deb root
  PYTHONPATH=root/usr/lib/python3/dist-packages "$python" -c "
import isomatch
assert isomatch.__version__ == '$version'
isomatch.match('pose1.off', 'pose2.off').save('result_of_python')"
  cmp result/source_to_target.txt result_of_python/source_to_target.txt || fail "Python's map"
fi
