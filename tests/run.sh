#!/bin/sh
# SPDX-License-Identifier: MIT
# The tests that every change passes: on a bare Debian 12, as root or with sudo, from any folder. Installs what
# packages.debian and packages.tests.debian list, builds the program and runs it in the heavy tests; builds the libraries
# under the sanitizers and runs the quick tests; ends with two examples. Twelve minutes on two processors from nothing, and
# prints the seconds of each part. What takes longer stands in tests/thorough.sh.
#
#   tests/run.sh              all of that
#   tests/run.sh -k FOLDER    tests of one folder alone, as baker/shadow or end_to_end
set -eu
cd "$(dirname "$0")/.."
. examples/parts.sh
processors=$(nproc)
export LSAN_OPTIONS="suppressions=$PWD/.cmake/leaks_of_others.txt:print_suppressions=0" UBSAN_OPTIONS=print_stacktrace=1

# tested PRESET KIND: builds and runs tests of the one folder.
tested() {
  target=$(echo "$folder" | tr / _)_$2_tests
  ninja -C "build/$1" -t query "$target" >/dev/null 2>&1 || return 0
  part "$1: build of $target"
  cmake --build "build/$1" --target "$target"
  part "$1: $2 tests of $folder"
  ctest --test-dir "build/$1" -L "^$2$" -R "^$folder/[^/]*$" --output-on-failure --parallel "$processors" --no-tests=error
  found=yes
}

if [ "${1:-}" = -k ] && [ $# -eq 2 ]; then
  folder=${2%/} found=
  sh examples/build.sh coppermoon_test_main packages.tests.debian
  cmake --preset sanitizers >/dev/null
  tested sanitizers quick
  tested release heavy
  [ -n "$found" ] || { echo "$folder: has no tests, allowed is a folder as baker/shadow or end_to_end" >&2; exit 2; }
  exit
elif [ $# -gt 0 ]; then
  echo "tests/run.sh $*: allowed is nothing, or -k FOLDER" >&2
  exit 2
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"; end_parts' EXIT
export COPPERMOON_PROCESSOR_SECONDS="$scratch/processor_seconds"
sh examples/build.sh "coppermoon_program heavy_tests" packages.tests.debian
part "tests of the program, in release"
ctest --test-dir build/release --label-exclude "quick|slow|sweep|hand_off" --output-on-failure --parallel "$processors" \
  --no-tests=error

part "build under the address and undefined-behaviour sanitizers"
cmake --preset sanitizers
cmake --build --preset sanitizers
part "tests of the libraries, under the sanitizers"
ctest --preset sanitizers --parallel "$processors" --no-tests=error

part "two examples, small"
root=$PWD
cd "$scratch"
small="--photons 2e4 --texture-width 512 --width 150 --height 100"
"$root/examples/first_eclipse.sh" $small
"$root/examples/standard_figures.sh" $small
ls -l
cd "$root"
part ''
printf '\n== the ten dearest tests, in seconds of processor\n'
sort -rn "$COPPERMOON_PROCESSOR_SECONDS" | head -n 10
end_parts
printf '\n== all passed\n'
budget=$(sed -n 's/^| in all | *\([0-9]*\) |$/\1/p' tests/README.md)
awk -v used="$used_in_all" -v budget="$budget" 'BEGIN { if (used > 1.1 * budget)
  printf "Over the budget of %d s of processor (tests/README.md) by %.0f %%: give seconds back.\n", budget, 100 * (used / budget - 1) }'
