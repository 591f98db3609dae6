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
Made by `examples/plans.sh`: what `coppermoon plan` chooses for six scenes, all within 1 % of luminance anywhere on the
disc but for the preview's 5 %. What is left out stands with what luminance would change by at most.
EOF
scene "Penumbra alone" "The Moon has just touched the penumbra: sunlight that passes clear of the air outshines what \
came through it, so no ray is followed through the air at all." 2009-02-09T12:40:00Z
scene "Deep in the umbra" "The axis goes through the disc, and so little light is refracted there that what the air \
scatters into the shadow counts." 2011-06-15T20:13:00Z
scene "Air alike all around" "Without clouds and seasons there is one column to follow light through, and light that \
differs around the axis by the Earth's oblateness alone." 2018-07-27T20:21:45Z --atmosphere clear
scene "A Moon at 3 degrees altitude" "The same eclipse as it rises over London: the frame shows the disc flattened by \
refraction, which is left out where it is less than a quarter of a pixel; the texture is as large as the frame can show." \
  2018-07-27T20:21:45Z --at 51.5,0 --width 450 --height 300
scene "A preview of 256 pixels" "Drafts may be wrong by 5 %, which fewer rays keep to; the \
texture is no larger than so small a frame can show." 2008-02-21T03:26:05Z --quality draft --width 256 --height 256
scene "A map of 16384 texels" "Light is computed as for any other map: the time goes into texels." \
  2008-02-21T03:26:05Z --texture-width 16384
"$here/made_at.sh" "examples/plans.sh $*"
