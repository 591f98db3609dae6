#!/bin/sh
# SPDX-License-Identifier: MIT
# One eclipse as a film three ways: a texture for each frame, Blender's node group, POV-Ray's clock: three_films.md on stdout.
# A minute.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" "coppermoon_program hand_off_tests" packages.tests.debian packages.hand_off.debian >&2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$here/../build/release/tests/hand_off_hand_off_tests" three_films > "$scratch/said" || { cat "$scratch/said" >&2; exit 1; }

cat <<'EOF'
# Three films of one eclipse

Made by `examples/three_films.sh`: the partial phase and half the totality of 27 July 2018 in five frames of 300 × 300 pixels, from
the Earth's centre, textures of 1024 texels. First with a texture for each frame; then by the shader of `coppermoon shader`: in
Blender, where the add-on has put it into a node group, and in POV-Ray, where `clock` is the time.

| film | seconds | MB | difference, rms | largest |
| --- | ---: | ---: | ---: | ---: |
EOF
sed -n '/^|/p' "$scratch/said"
cat <<'EOF'

Seconds: of everything, baking and rendering. MB: textures, strip and shaders; those of the first film grow with its frames, a film of 240 has 48 times as much; those of
the others do not, but for the add-on's small textures, by which it knows light and camera of each frame. Difference: of luminance,
pixel by pixel, 4 pixels and more inside the limb; rays meet the ground's relief elsewhere in each renderer.
EOF
"$here/made_at.sh"
