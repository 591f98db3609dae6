#!/bin/sh
# SPDX-License-Identifier: MIT
# Seconds and errors of each quality: the table of docs/speed.md, on stdout. Two minutes.
#
# Given  TEXELS=4096  width of the texture
set -eu
here=$(cd "$(dirname "$0")" && pwd)
texels=${1:-4096}
"$here/build.sh" >&2
coppermoon=$here/../build/release/coppermoon
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
moment=2008-02-21T03:26:05Z

# seconds TIMES FLAGS: median of the clock's; what the last said stays in said.json.
seconds() {
  times=$1
  shift
  for _ in $(seq "$times"); do
    begun=$(date +%s.%N)
    "$coppermoon" bake $moment --texture-width "$texels" "$@" -o "$scratch/moon.exr" --json >"$scratch/said.json" 2>/dev/null
    date +%s.%N | awk -v begun="$begun" '{ print $1 - begun }'
  done | sort -n | awk '{ each[NR] = $1 } END { printf "%.2g s", each[int((NR + 1) / 2)] }'
}

# error NAME: predicted or reached, of said.json.
error() {
  awk -v name="$1" '$1 == "\"" name "\":" { inside = 1 }
                    inside && $1 == "\"error\":" { printf "%.2g %%", 100 * $2; exit }' "$scratch/said.json"
}

# row WORDS WISH TIMES FLAGS
row() {
  words=$1 wish=$2 times=$3
  shift 3
  undated=$(seconds "$times" "$@" --atmosphere undated)
  taken=$(seconds "$times" "$@")
  echo "| $words | $wish | $taken | $undated | $(error predicted) | $(error reached) |"
}

echo "| \`--quality\` | asks for | a texture $texels wide takes | in \`undated\` air | error predicted | error found |"
echo "| --- | --- | ---: | ---: | ---: | ---: |"
row '`draft`' "5 %" 3 --quality draft
row '`standard`' "1 %" 3 --quality standard
row '`standard`, dust over the south' "1 %" 3 --quality standard \
  --region from-latitude=-90,to-latitude=0,dust-extinction=1e-5
row '`reference`' "0.05 %" 1 --quality reference
"$coppermoon" plan $moment --quality paper --json >"$scratch/said.json" 2>/dev/null
awk '/"predicted"/ { inside = 1 } inside && /"seconds"/ { minutes = $2 / 60 } inside && /"error"/ { error = $2; exit }
     END { printf "| `paper` | 1e7 photons, traced step by step | %.0f min (predicted) | | %.0f %% | |\n", minutes, 100 * error }' \
  "$scratch/said.json"
printf '\n21 February 2008, 03:26:05 UTC, built-in Moon, medians of three, `reference` once.\n'
"$here/made_at.sh" "examples/qualities.sh $*"
