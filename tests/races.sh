#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the quick tests of folders that use threads under ThreadSanitizer; exits 1 on a race.
#
#   tests/races.sh             all of them
#   tests/races.sh FOLDER …    these, as baker/shadow
#
# Builds oneTBB under it first, from Debian's source, into build/tsan_tbb. ThreadSanitizer does not see how Debian's own
# hands a task from one thread to another, and reports each as a race. No suppression tells these from races of ours, for
# all of our loops run below frames of oneTBB. Races of other libraries stand in .cmake/races_of_others.txt, with the reason.
# Deadlocks are not looked for: the detector ends a program of which a thread holds 64 locks.
set -eu
cd "$(dirname "$0")/.."
export TSAN_OPTIONS="suppressions=$PWD/.cmake/races_of_others.txt print_suppressions=0 detect_deadlocks=0"
[ $# -gt 0 ] || set -- baker/files baker/photons baker/shadow baker/surface baker/texture colour
command -v clang++ >/dev/null || { echo "clang++: not found; install the package clang" >&2; exit 1; }
tbb=$PWD/build/tsan_tbb

if [ ! -f "$tbb/lib/cmake/TBB/TBBConfig.cmake" ]; then
  rm -rf "$tbb"
  mkdir -p "$tbb/apt/lists/partial"
  cd "$tbb/apt"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main" >list
  apt="apt-get -q -o Dir::Etc::sourcelist=$PWD/list -o Dir::Etc::sourceparts=- -o Dir::State::lists=$PWD/lists"
  apt="$apt -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache="
  $apt update
  $apt source onetbb
  cd ../../..
  cmake -S "$tbb"/apt/onetbb-*/ -B "$tbb/build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_C_COMPILER=clang \
    -DCMAKE_CXX_COMPILER=clang++ -DTBB_SANITIZE=thread -DTBB_TEST=OFF -DCMAKE_INSTALL_PREFIX="$tbb"
  cmake --build "$tbb/build" --target install
fi

cmake --preset tsan
for folder; do echo "$folder" | tr / _; done | sed 's/$/_quick_tests/' |
  xargs cmake --build build/tsan --target sanitizers_planted
for folder in sanitizers "$@"; do
  ctest --test-dir build/tsan -L '^quick$' -R "^$folder/[^/]*$" --output-on-failure --parallel "$(nproc)" --no-tests=error
done
