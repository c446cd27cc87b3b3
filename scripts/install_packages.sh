#!/bin/bash
# Installs what is missing of the Debian packages that packages.txt lists under the given sections.
# Usage: scripts/install_packages.sh SECTION...
set -euo pipefail

list=$(dirname "$0")/packages.txt

packages_of() {
  awk -v section="[$1]" '/^\[/ { inside = ($0 == section); next } inside && /^[^#]/' "$list"
}

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

as_root() {
  if [ "$(id -u)" = 0 ]; then "$@"; else sudo --non-interactive "$@"; fi
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install --yes --quiet --no-install-recommends "$@" </dev/null
}

if ! command -v dpkg-query >/dev/null; then
  echo "Not a Debian system; expecting the packages of $list to be there." >&2
  exit 0
fi

missing=()
for section in "$@"; do
  for package in $(packages_of "$section"); do
    is_installed "$package" || missing+=("$package")
  done
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "Installing: ${missing[*]}"
if ! as_root true 2>/dev/null; then
  echo "Cannot install without root or sudo; please run: apt-get install ${missing[*]}" >&2
  exit 1
fi
# The package lists may be absent or outdated: fetch them only then.
apt_install "${missing[@]}" || { as_root apt-get update --quiet && apt_install "${missing[@]}"; }
