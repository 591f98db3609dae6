#!/bin/sh
# SPDX-License-Identifier: MIT
# On a bare Debian 12, as root or with sudo, from any folder: installs what packages.debian lists, builds everything,
# compiles each public header alone, runs all tests, most of them again under the sanitizers, and the fuzzers for two
# minutes each. On two processors within 75 minutes.
set -eu
cd "$(dirname "$0")/.."
say() { printf '\n== %s\n' "$*"; }

say "packages and build"
sh examples/build.sh all
cmake --build --preset release --target all_verify_interface_header_sets

say "tests"
ctest --preset release --parallel "$(nproc)"

say "slow tests"
ctest --test-dir build/release --label-regex slow --output-on-failure --no-tests=ignore --parallel "$(nproc)"
ctest --test-dir build/release --label-regex sweep --tests-regex '/0$' --output-on-failure

say "address and undefined-behaviour sanitizers"
cmake --preset sanitizers
cmake --build --preset sanitizers
ctest --preset sanitizers --parallel "$(nproc)"

say "fuzzers"
tests/fuzz.sh 120

say "examples, small"
root=$PWD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
small="--texture-width 512 --width 150 --height 100"
few="--photons 2e4 $small"
"$root/examples/first_eclipse.sh" $few
"$root/examples/standard_figures.sh" $few
"$root/examples/paper_figures.sh" $few
"$root/examples/photon_convergence.sh" 1e4
"$root/examples/term_sizes.sh" $small
"$root/examples/tradeoff.sh" --quick
"$root/examples/plans.sh"
"$root/examples/film.sh" --frames 4
"$root/examples/gallery/gallery.sh" --width 150 --height 100
ls -l

say "all passed"
