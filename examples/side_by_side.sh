#!/bin/sh
# SPDX-License-Identifier: MIT
# The same eclipsed Moon by POV-Ray, by Blender and by a ray through each pixel: side_by_side.md on stdout, the three and
# their differences in ./side_by_side.png. Half a minute.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" "coppermoon_program hand_off_tests" packages.tests.debian packages.hand_off.debian >&2
build=$here/../build/release
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

COPPERMOON_FRAMES=$scratch "$build/tests/hand_off_hand_off_tests" side_by_side > "$scratch/said" || { cat "$scratch/said" >&2; exit 1; }
cd "$scratch"
for name in povray blender; do oiiotool $name.exr reference.exr --absdiff --mulc 20 -o off_$name.exr; done
for name in povray blender reference off_povray off_blender; do
  "$build/coppermoon" develop $name.exr --time 4 -o $name.png >&2
done
oiiotool --nosoftwareattrib povray.png blender.png reference.png off_povray.png off_blender.png --mosaic:pad=4 5x1 -o side_by_side.png
cp side_by_side.png "$OLDPWD"

cat <<'EOF'
# Side by side

Made by `examples/side_by_side.sh`. The pictures show the eclipse of 21 February 2008, 03:26:05 UTC, from 42.86° N,
73.77° W. One texture is rendered by POV-Ray, by Blender (the add-on), and by a reference with 8 × 8 rays through each
pixel. The last two pictures show how POV-Ray and Blender differ from the reference, twenty times as bright. Each
picture has 300 × 300 pixels, and the disc is 262 pixels wide.

![](pictures/side_by_side.png)

| frame | against | luminance within 1 % | light of the disc | centroid [px] | shift [px] |
| --- | --- | ---: | ---: | ---: | ---: |
EOF
sed -n '/^|/p' said
cat <<'EOF'

Luminance is compared in pixels more than 2 px inside the limb. The centroid is that of all light. The shift is found by
least squares over the frame. `coppermoon scene` asks for 3 × 3 rays: to a pixel's middle, edges and corners.
Neighbouring pixels share edges and corners, so each pixel extends a little into the next. With more rays (`povray
eclipse.ini +R5`) this effect disappears.
EOF
"$here/made_at.sh" "examples/side_by_side.sh $*"
