#!/bin/sh
# SPDX-License-Identifier: MIT
# One eclipse as a film three ways: a texture for each frame, Blender's node group, POV-Ray's clock: three_films.md on stdout,
# their frames in ./three_films.png. A minute.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" "coppermoon_program hand_off_tests" packages.tests.debian packages.hand_off.debian >&2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
build=$here/../build/release
COPPERMOON_FRAMES=$scratch "$build/tests/hand_off_hand_off_tests" three_films > "$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
pictures=""
for film in textures blender povray; do
  for frame in 1:1/250 2:1/30 3:1/4 4:2 5:4; do
    name=$film${frame%:*}
    "$build/coppermoon" develop "$scratch/$name.exr" --time "${frame#*:}" --space lin_rec709 -o "$scratch/$name.png" >&2
    oiiotool "$scratch/$name.png" --resize 160x160 -o "$scratch/$name.png"
    pictures="$pictures $scratch/$name.png"
  done
done
# shellcheck disable=SC2086
oiiotool --nosoftwareattrib $pictures --mosaic:pad=2 5x3 -o three_films.png

cat <<'EOF'
# Three films of one eclipse

Made by `examples/three_films.sh`. The films show the partial phase and half the totality of 27 July 2018 in five frames
of 300 × 300 pixels, as seen from the Earth's centre, with textures of 1024 texels. The first film uses a texture for
each frame. The others use the shader from `coppermoon shader`: in Blender, where the add-on puts it into a node group,
and in POV-Ray, where `clock` is the time.

![Rows: textures, Blender, POV-Ray](pictures/three_films.png)

| film | seconds | MB | difference, rms | largest |
| --- | ---: | ---: | ---: | ---: |
EOF
sed -n '/^|/p' "$scratch/said"
cat <<'EOF'

Seconds include baking and rendering. MB counts textures, strip and shaders. The size of the first film grows with its
frames: a film of 240 frames has 48 times as much. The size of the others does not grow, except for the small textures
from which the add-on reads light and camera of each frame. The difference is that in luminance, pixel by pixel, 4
pixels or more inside the limb. In each renderer, rays meet the ground's relief at different points.
EOF
"$here/made_at.sh" "examples/three_films.sh $*"
