#!/bin/sh
# SPDX-License-Identifier: MIT
# What six scenes require, and why it differs: plans.md on stdout. A few seconds.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" >&2
PATH=$here/../build/release:$PATH

# scene TITLE WHY FLAGS: its plan.
scene() {
  title=$1 why=$2
  shift 2
  printf '\n**%s.** %s\n\n```\n$ coppermoon plan %s\n' "$title" "$why" "$*"
  coppermoon plan "$@"
  printf '```\n'
}

cat <<'EOF'
Made by `examples/plans.sh`. This page shows what `coppermoon plan` chooses for six scenes, all within 1 % of luminance
anywhere on the disc, except the preview, which allows 5 %. Each effect left out is listed with the largest change in
luminance that it would make.
EOF
scene "Penumbra alone" "The Moon has just touched the penumbra. Sunlight that misses the air outshines \
the light that came through it, so no ray is traced through the air at all." 2009-02-09T12:40:00Z
scene "Deep in the umbra" "The axis passes through the disc. So little light is refracted there that the light \
scattered into the shadow by the air matters." 2011-06-15T20:13:00Z
scene "Air alike all around" "Without clouds and seasons there is only one column of air to trace rays through. \
The light then differs around the axis only because the Earth is oblate." 2018-07-27T20:21:45Z --atmosphere clear
scene "A Moon at 3 degrees altitude" "This is the same eclipse as the Moon rises over London. The frame shows the disc \
flattened by refraction, which is left out if it is less than a quarter of a pixel. The texture is as large as the frame can show." \
  2018-07-27T20:21:45Z --at 51.5,0 --width 450 --height 300
scene "A preview of 256 pixels" "A draft may be wrong by 5 %, which needs fewer rays. The texture \
is no larger than such a small frame can show." 2008-02-21T03:26:05Z --quality draft --width 256 --height 256
scene "A map of 16384 texels" "Light is computed as for any other map. Most of the time is spent on texels." \
  2008-02-21T03:26:05Z --texture-width 16384
"$here/made_at.sh" "examples/plans.sh $*"
