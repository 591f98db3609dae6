#!/bin/sh
# SPDX-License-Identifier: MIT
# Reads the program's sources with clang-tidy and the checks of .clang-tidy; exits 1 where one finds something.
#
#   tests/tidy.sh             all sources
#   tests/tidy.sh FOLDER …    those of these folders, as baker/shadow
#
# Compiles nothing: one source after another, each by itself, with the flags of the preset `sanitizers`. Sources for other
# systems are left to their own compilers.
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- baker colour povray_scenes examples
command -v clang-tidy-14 >/dev/null || { echo "clang-tidy-14: not found; install the package clang-tidy" >&2; exit 1; }
cmake --preset sanitizers -B build/tidy -DCMAKE_UNITY_BUILD=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCOPPERMOON_TESTS=OFF \
  >/dev/null
mkdir -p build/tidy/installed
ln -sfn "$PWD/baker" build/tidy/installed/coppermoon  # which examples include
find "$@" -name '*.cpp' ! -name '*_windows.cpp' ! -name 'macos_*' | sort |
  xargs -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p build/tidy --extra-arg="-I$PWD" \
    --extra-arg="-I$PWD/build/tidy/installed" 2>/dev/null || exit 1
