#!/bin/sh
# SPDX-License-Identifier: MIT
# Eclipses at the moments, places and exposures of well-known photographs: a sheet, ./beside_photographs.jpg, and on stdout
# beside_photographs.md, from which docs/beside_photographs.md has its figures. Two minutes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" coppermoon_program packages.tests.debian >&2
coppermoon() { "$here/../build/release/coppermoon" "$@"; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
still() { coppermoon still "$@" --width 300 --height 300 --up zenith >&2 </dev/null; }
numbers() { oiiotool --dumpdata "$1" | sed -n 's/.*Pixel (\(.*\), \(.*\)): \(.*\)/\1 \2 \3/p'; }
V() { coppermoon brightness "$@" --json | awk '/"V"/ { printf "%.2f", $2 }'; }

cat <<'END'
Made by `examples/beside_photographs.sh`. This page contains the figures of
[`docs/beside_photographs.md`](../docs/beside_photographs.md).

END
echo "| command | brightest hundredth of the disc, over saturation |"
echo "| --- | ---: |"
while read -r name seconds flags; do
  still $flags --frame "$scratch/$name.exr" -o "$scratch/auto.png"
  lens=$(echo "$flags" | grep -o -e '--f-number [0-9.]*' -e '--iso [0-9]*')
  coppermoon develop "$scratch/$name.exr" $lens --time "$seconds" -o "$scratch/$name.png" >&2 </dev/null
  auto=$(oiiotool --info -v "$scratch/auto.png" | sed -n 's/.*ExposureTime: "\(.*\)"/\1/p')
  echo "| \`still $flags --time $seconds\` | $(awk "BEGIN { printf \"%.2f\", 0.8 * $seconds / $auto }") |"
done <<'END'
2008_1 1/2 2008-02-21T02:56Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2008_2 1 2008-02-21T02:58Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2008_3 2 2008-02-21T03:01Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2008_4 8 2008-02-21T03:15Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2008_5 2 2008-02-21T03:51Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2008_6 2 2008-02-21T03:53Z --at 34.31,-117.47 --f-number 9 --iso 200 --stars off
2014 15 2014-10-08T10:58Z --at 49.08,-111.62 --f-number 6 --iso 400 --field 1.3
2015 1/2 2015-09-28T02:51Z --at 30.63,-97.68 --f-number 6.3 --iso 3200
2018 1 2018-07-27 U3-5min --at 42.33,13.69 --f-number 5 --iso 3200 --field 15
2019 4 2019-01-21 --at 53.28,-110 --f-number 4 --iso 400
by_hand 1/100 2019-01-21T04:58:33Z --at 38.9,-77.04 --f-number 5.6 --iso 12800
2025 1 2025-03-14 --at 33.7,-117.8 --f-number 6.4 --iso 400
END
still 2022-05-16 U3-2min --at 42.4,-72.7 -o "$scratch/2022.png"

echo
for planet in "Uranus 2014 1.3" "Mars 2018 15"; do  # the brightest point beside the Moon, in a field of so many degrees
  set -- $planet
  numbers "$scratch/$2.exr" | awk -v what="$1, $2" -v field="$3" '
    { x = $1 - 149.5; y = 149.5 - $2; from = sqrt(x^2 + y^2) }
    from < 70 && $4 > 0.01 { disc++ }
    from > 70 && $4 > most { most = $4; far = from; turn = atan2(x, y) / atan2(0, -1) * 6 }
    END { printf "* %s: %.2f° from the Moon, %.2f° from its limb, at %.1f o\047clock\n", what, far * field / 300,
                 (far - sqrt(disc / atan2(0, -1))) * field / 300, (turn + 12) % 12 }'
done

# The white balance that makes the full Moon of that night grey, as photographers set it.
still 2008-02-21T03:51Z --at 34.31,-117.47 --stars off --unshadowed --frame "$scratch/full.exr" -o "$scratch/full.png"
white=$(oiiotool --stats "$scratch/full.exr" | awk '/Stats Avg/ { print $4 / $3 ",1," $4 / $5 }')
oiiotool "$scratch/2008_5.exr" --mulc "$white" -o "$scratch/white.exr"
coppermoon develop "$scratch/white.exr" --f-number 9 --iso 200 --time 2 -o "$scratch/white.png" >&2
numbers "$scratch/white.exr" | awk '$3 > 0.01 && $5 / $3 > most { most = $5 / $3 }
  END { printf "* 2008-02-21T03:51Z: blue over red at the bluest place, over that of the full Moon: %.2f\n", most }'

dimming="$(V 2015-09-28) - ($(V 2015-09-28 --unshadowed))"
echo "* 2015-09-28: fainter than the full Moon by $(awk "BEGIN { d = $dimming; printf \"%.2f mag, %.0f times\", d, 10^(0.4 * d) }")"
for aerosol in dated background; do
  echo "* 2022-11-08: V $(V 2022-11-08 --stratospheric-aerosol "$aerosol"), stratospheric aerosol $aerosol"
done
coppermoon almanac --from 2025-03-14 --to 2025-03-15 --feature 18.56,61.81 --json |
  sed -n 's/.*"\([a-z]*mersion\)": "\(.*\)".*/* 2025-03-14 at 18.56° N, 61.81° E: \1 \2/p'
"$here/made_at.sh" examples/beside_photographs.sh

cd "$scratch"
oiiotool --nosoftwareattrib 2008_1.png 2008_4.png 2008_5.png white.png 2014.png 2015.png 2018.png 2019.png 2022.png \
  --mosaic:pad=4 3x3 --compression jpeg:88 -o beside_photographs.jpg
cp beside_photographs.jpg "$OLDPWD"
