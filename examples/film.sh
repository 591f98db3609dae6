#!/bin/sh
# SPDX-License-Identifier: MIT
# A whole eclipse as a film, in ./film, and how long it takes beside POV-Ray alone on ready scenes and OpenImageIO alone on
# the same files: film.md on stdout.
#
# Given  FLAGS  of `coppermoon animate`, as --frames 8
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" >&2
coppermoon=$here/../build/release/coppermoon
film="2018-07-27 --at -21.1,55.5 --field 1.1 --width 960 --height 540 --frames 240 $*"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# seconds NAME COMMAND…: as the variable NAME
seconds() {
  name=$1
  shift
  begun=$(date +%s.%N)
  "$@" >&2
  eval "$name=$(date +%s.%N | awk -v begun="$begun" "{ print \$1 - begun }")"
}

# shellcheck disable=SC2086
seconds whole "$coppermoon" animate $film -o film
# shellcheck disable=SC2086
"$coppermoon" animate $film -o film --contact-sheet film/sheet.png --curve film/curve.svg --curve film/curve.csv >&2
# shellcheck disable=SC2086
"$coppermoon" animate $film --make scenes -o "$scratch/scenes" >&2
cd "$scratch/scenes"
frames=$(find . -name 'moon_lin_rec709.*.exr' | wc -l)
seconds povray sh -c 'povray eclipse.ini -GA >/dev/null 2>&1'
seconds textures oiiotool --frames "1-$frames" "moon_lin_rec709.%04d.exr" --compression piz -o "$scratch/again.%04d.exr"
seconds pictures oiiotool --frames "1-$frames" "frame.%04d.exr" -d uint8 -o "$scratch/again.%04d.png"

awk -v n="$frames" -v whole="$whole" -v povray="$povray" -v textures="$textures" -v pictures="$pictures" 'BEGIN {
  floor = povray + textures + pictures
  print "# A film, and what it cannot take less than\n"
  printf "Made by `examples/film.sh`. The film shows the eclipse of 27 July 2018 from P1 to P4 in %d frames of 960 x 540, timed in one run.\n\n", n
  print "| what | seconds | a frame |\n| --- | ---: | ---: |"
  printf "| `coppermoon animate`, from the light to developed pictures | %.0f | %.2f |\n", whole, whole / n
  printf "| POV-Ray alone, the scenes ready, one process | %.0f | %.2f |\n", povray, povray / n
  printf "| OpenImageIO alone, the textures read and written | %.0f | %.2f |\n", textures, textures / n
  printf "| OpenImageIO alone, the frames read and pictures written | %.0f | %.2f |\n", pictures, pictures / n
  printf "\nThe film takes %.2f of the time of these three together, because it renders only the part of each frame that the Moon\n", whole / floor
  print "covers. POV-Ray also sleeps for a third of a second at each frame, and several processes with one thread each are quicker"
  print "than one with several threads."
}'
"$here/made_at.sh" "examples/film.sh $*"
