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

Made by `examples/side_by_side.sh`: the eclipse of 21 February 2008, 03:26:05 UTC, from 42.86° N, 73.77° W; one texture, by
POV-Ray, by Blender (the add-on), and by 8 × 8 rays through each pixel, the reference; then what POV-Ray and
Blender differ from the reference, twenty times as bright. 300 × 300 pixels, a disc 262 wide.

![](pictures/side_by_side.png)

| frame | against | luminance within 1 % | light of the disc | centroid [px] | shift [px] |
| --- | --- | ---: | ---: | ---: | ---: |
EOF
sed -n '/^|/p' said
cat <<'EOF'

Luminance: of the pixels more than 2 px inside the limb. Centroid: of all light. Shift: by least squares over the frame.
3 × 3 rays are what `coppermoon scene` asks for: to a pixel's middle, edges and corners, which are another's too, so that each
pixel reaches a little into the next; with more rays (`povray eclipse.ini +R5`) that is gone.
EOF
"$here/made_at.sh" "examples/side_by_side.sh $*"
