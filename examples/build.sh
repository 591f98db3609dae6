#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the packages that are missing (as root or with sudo) and builds build/release/coppermoon.
#
# Given  TARGETS=coppermoon_program  of the build, in one word with spaces between
#        LIST ...                    of more packages, as packages.tests.debian
set -eu
cd "$(dirname "$0")/.."
. examples/parts.sh
targets=${1:-coppermoon_program}
[ $# -eq 0 ] || shift
missing=
for package in $(sed 's/#.*//' packages.debian "$@"); do
  dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q ' installed$' ||
    command -v "$package" >/dev/null || missing="$missing $package"  # npm comes by many ways
done
if [ -n "$missing" ]; then
  part "packages"
  echo "Installing$missing"
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  $sudo apt-get update -qq
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
fi
part "build: $targets"
cmake --preset release
cmake --build --preset release --target $targets
