#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the packages that are missing (as root or with sudo) and builds build/release/coppermoon.
set -eu
cd "$(dirname "$0")/.."
missing=
for package in $(sed 's/#.*//' packages.debian); do
  dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q ' installed$' || missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "Installing$missing"
  sudo=$([ "$(id -u)" = 0 ] || echo sudo)
  $sudo apt-get update -qq
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
fi
cmake --preset release
cmake --build --preset release --target "${1:-coppermoon_program}"
