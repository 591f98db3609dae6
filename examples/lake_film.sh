#!/bin/sh
# SPDX-License-Identifier: MIT
# A film of a POV-Ray scene: the lake of gallery/lake_film.pov from moonrise in the dusk through totality, 7 September 2025, 10 s.
# Leaves the frames in ./lake_film, and there lake.mp4 and sheet.png. A frame of 960 x 540 takes five seconds of one processor:
# eleven minutes on two.
#
# Given  FLAGS  of `coppermoon animate`, as --width 320 --height 180 (which takes three minutes), or --range 1,125,250
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" coppermoon_program packages.tests.debian >&2
whole="--movie lake_film/lake.mp4 --contact-sheet lake_film/sheet.png"
case " $* " in *" --range "* | *" --shard "*) whole= ;; esac
# shellcheck disable=SC2086
"$here/../build/release/coppermoon" animate 2025-09-07 --at 41.09,20.76 --to U3 --scene "$here/gallery/lake_film.pov" \
  --duration 10s --fps 25 --width 960 --height 540 --texture-width 360 --make frames,pictures \
  --f-number 2 --iso 3200 --time moonrise:1/4000,U2:1/20,U2+25min:1/3 --view Filmic $whole -o lake_film "$@"
