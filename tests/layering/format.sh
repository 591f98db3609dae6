#!/bin/sh
# SPDX-License-Identifier: MIT
# Every C++ file is as clang-format 14 writes it. Another version breaks some lines elsewhere: skipped there.
#
#   tests/layering/format.sh CLANG_FORMAT
set -eu
cd "$(dirname "$0")/../.."
case $("$1" --version) in *"version 14."*) ;; *) echo "$1 is not of version 14"; exit 77 ;; esac
find baker colour examples povray_scenes tests \( -name '*.cpp' -o -name '*.h' \) -print0 |
  xargs -0 "$1" --dry-run --Werror
