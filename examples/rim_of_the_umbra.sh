#!/bin/sh
# SPDX-License-Identifier: MIT
# Rim of the umbra as the CIE observer and cameras see it: rim_of_the_umbra.md on stdout, and a picture,
# ./rim_of_the_umbra.jpg. Further flags go to `coppermoon shadow` and `still`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" coppermoon_program packages.tests.debian >&2
coppermoon="$here/../build/release/coppermoon"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat <<'END'
Made by `examples/rim_of_the_umbra.sh`. The table gives the least ratio of red to blue in linear Rec.709, relative to
that of full moonlight and averaged over all position angles, and its distance from the shadow's axis.

END
echo '| eclipse | response | least red over blue | at [km] | red below blue, width [arcmin] |'
echo '| --- | --- | ---: | ---: | ---: |'
for day in 2008-02-21 2018-07-27; do
  for response in colorimetric canon-eos-600d canon-eos-5d-mark-iii sony-ilce-7m3 nikon-d850; do
    "$coppermoon" shader "$day greatest" -o "$work/rim" --response $response "$@" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
    number() { sed -n "s/.*\"$1\": \([0-9.]*\).*/\1/p" "$work/rim/eclipse.json"; }
    four() { tr -d ' \n' < "$work/rim/eclipse.json" | sed "s/.*\"$1\":\[\([^]]*\)\].*/\1/"; }
    columns=$(number columns)
    oiiotool "$work/rim/eclipse.exr" --cut "${columns}x$(number sectors)+0+0" --dup --mul --resize:filter=box "${columns}x1" -o "$work/row.exr"
    oiiotool --info --dumpdata "$work/row.exr" | awk -v day=$day -v response=$response -v stretches="$(four stretches)" \
      -v ends="$(four ends_km)" -v depth="$(number middle_km)" '
      BEGIN {
        split(stretches, count, ","); split(ends, end, ",")
        for (s = 1; s <= 4; ++s) {
          from = s > 1 ? end[s - 1] : 0
          for (i = 0; i < count[s]; ++i) at[nodes++] = from + (end[s] - from) * i / count[s]
        }
        from = 0
      }
      /Pixel/ {
        km = at[n++]; red = $4; blue = $6
        if (km < 2500 || km > 5600 || blue <= 0) next
        if (!least || red / blue < least) { least = red / blue; place = km }
        if (red < blue) { if (!from) from = km; to = km }
      }
      END { printf "| %s | %s | %.2f | %.0f | %.1f |\n", day, response, least, place, (to - from) / depth * 3437.75 }'
  done
done
for response in colorimetric canon-eos-600d sony-ilce-7m3; do
  "$coppermoon" still "2018-07-27 U2-4min" --at Nairobi --time 2 --width 900 --height 900 --response $response \
    -o "$work/$response.png" "$@" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  oiiotool "$work/$response.png" --cut 400x460+430+220 -o "$work/$response.rim.png"
done
oiiotool --nosoftwareattrib "$work/colorimetric.rim.png" "$work/canon-eos-600d.rim.png" "$work/sony-ilce-7m3.rim.png" --mosaic 3x1 \
  --compression jpeg:92 -o rim_of_the_umbra.jpg
"$here/made_at.sh" "examples/rim_of_the_umbra.sh $*"
