#!/bin/sh
# SPDX-License-Identifier: MIT
# Speed against accuracy, measured for every method and setting: makes tradeoff.md and docs/pictures/tradeoff.svg again, in
# about five minutes on two processors. With flags, as --quick or --longest 60: what they make, into the folder tradeoff.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh"
measure() { "$here/../build/release/coppermoon" tradeoff "$@"; }
if [ $# -gt 0 ]; then
  measure -o tradeoff "$@"
  exit
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
measure -o "$scratch"
{ cat "$scratch/tradeoff.md"; "$here/made_at.sh" examples/tradeoff.sh; } >"$here/tradeoff.md"
mv "$scratch/tradeoff.svg" "$here/../docs/pictures/tradeoff.svg"
