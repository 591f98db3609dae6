#!/bin/sh
# SPDX-License-Identifier: MIT
# Ends a page of figures: the commit and the machine that they were made at, on stdout.
set -eu
cd "$(dirname "$0")"
commit=$(git describe --always --dirty --exclude '*' 2>/dev/null) || commit="version $(../build/release/coppermoon --version | awk '{ print $NF; exit }')"
processor=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)
printf '\nMade at %s, on %s processors (%s).\n' "$commit" "$(nproc)" "${processor:-unknown}"
