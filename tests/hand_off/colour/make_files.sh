#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes eleven files, whose names name no colour space: make_files.sh COPPERMOON FOLDER
set -eu
coppermoon=$1
mkdir -p "$2"
cd "$2"
moment="2018-07-27T19:20:00Z --albedo-map built-in --quality draft"
for space in acescg lin_rec709 lin_ciexyzd65_scene; do
  mkdir -p "$space"
  "$coppermoon" bake $moment --texture-width 256 --passes --space "$space" -o "$space/a.exr" -o "$space/b.tx"
done
"$coppermoon" still $moment --at Nairobi --width 320 --height 240 --frame frame.exr -o frame.png
"$coppermoon" ring 2018-07-27T20:21:45Z -o ring.exr
"$coppermoon" bake $moment --texture-width 256 -o moon.glb -o moon_acescg.exr -o moon.usda
