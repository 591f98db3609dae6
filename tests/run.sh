#!/bin/sh
# SPDX-License-Identifier: MIT
# On a bare Debian 12, as root or with sudo, from any folder: installs what packages.debian lists, builds everything,
# compiles each public header alone, runs all tests, the slow ones last.
set -eu
cd "$(dirname "$0")/.."
say() { printf '\n== %s\n' "$*"; }

say "packages"
missing=
for package in $(sed 's/#.*//' packages.debian); do
  dpkg-query -W -f '${Status}\n' "$package" 2>/dev/null | grep -q ' installed$' || missing="$missing $package"
done
if [ -n "$missing" ]; then
  echo "installing$missing"
  sudo=
  [ "$(id -u)" = 0 ] || sudo=sudo
  $sudo apt-get update
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
fi

say "build"
cmake --preset release
cmake --build --preset release
cmake --build --preset release --target all_verify_interface_header_sets

say "tests"
ctest --preset release --parallel "$(nproc)"

say "slow tests"
ctest --test-dir build/release --label-regex slow --output-on-failure --no-tests=ignore

say "all passed"
