#!/bin/sh
# SPDX-License-Identifier: MIT
# On a bare Debian 12, as root or with sudo, from any folder: installs what packages.debian lists, builds everything,
# compiles each public header alone, runs all tests, the slow ones last.
set -eu
cd "$(dirname "$0")/.."
say() { printf '\n== %s\n' "$*"; }

say "packages and build"
sh examples/build.sh all
cmake --build --preset release --target all_verify_interface_header_sets

say "tests"
ctest --preset release --parallel "$(nproc)"

say "slow tests"
ctest --test-dir build/release --label-regex slow --output-on-failure --no-tests=ignore

say "all passed"
