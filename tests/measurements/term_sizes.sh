#!/bin/sh
# SPDX-License-Identifier: MIT
# How much each term of the physics changes, in the shadow and in the picture: term_sizes.md on stdout, largest first.
# Flags, as --width 150 --height 100, go to `coppermoon still` in place of its size here.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$here/../../build/release
given=$*
[ $# -gt 0 ] || set -- --texture-width 1024 --width 600 --height 400
size=$*
"$here/../../examples/build.sh" term_sizes packages.tests.debian >&2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

coppermoon() { "$build/coppermoon" "$@"; }
knows() { coppermoon "$1" --help-all | grep -q -e "$2 "; }
shadow() {
  coppermoon shadow "$@" --json --axis-distances 0,2300,4400 \
    --wavelengths 380,400,420,440,460,480,500,520,540,560,580,600,620,640,660,680,700,720,740,760,780
}
still() { coppermoon still "$@" --bits 16 --quality reference $size >&2; }

# scene INSTANT AND FLAGS: what the terms that follow are changed in. $view goes to `still` alone.
scene() {
  moon=$*
  shadow $moon > "$scratch/standard.json"
  still $moon $view --frame "$scratch/standard.exr" -o "$scratch/standard.png"
  time=$(coppermoon develop "$scratch/standard.exr" -o "$scratch/developed.png" --json |
    sed -n 's/.*"time_s": \([^,]*\).*/\1/p')
}

# term NAME FLAG VALUE: a row, or none where the program has no such flag.
term() {
  knows still "$2" || return 0
  moon_without=$(echo "$moon" | sed "s/ $2 [^ ]*//")
  standard=- changed=-
  if knows shadow "$2"; then
    standard=$scratch/standard.json changed=$scratch/changed.json
    shadow $moon_without $2 $3 > "$changed"
  fi
  still $moon_without $view $2 $3 --time "$time" -o "$scratch/changed.png"
  "$build/tests/measurements/term_sizes" "$1, \`$2 $3\`" "$standard" "$changed" "$scratch/standard.png" "$scratch/changed.png" \
    >> "$scratch/rows"
}

# off FLAG: the flag switched off, where the program has it.
off() { if knows still "$1"; then echo "$1 off"; fi; }

view="--at 42.86,-73.77"
scene 2008-02-21T03:26:00Z --atmosphere undated
term "limb darkening of the Sun" --limb-darkening off
term "the Earth's oblateness" --earth sphere
term "air from 42 to 86 km" --density yapo-cutler
term "dispersion of refraction" --dispersion crc
term "King's factor by wavelength" --king-factor fixed
term "ozone" --ozone-du 0
term "ozone along the path" --ozone-path filter
term "tropospheric aerosol" --tropospheric-aerosol 0
term "stratospheric aerosol" --stratospheric-aerosol none
term "cloud" --cloud-cover 0
term "Rayleigh scattering" --rayleigh off
term "refraction" --refraction off
term "a lunar photometric function" --photometry yapo-cutler

view="--at 42.86,43.3"
scene 2008-02-21T03:26:00Z --atmosphere undated
term "low Moon: the observer's air" --reddening off
term "low Moon: its aerosol" --observer-aerosol 0
term "low Moon: its ozone" --observer-ozone-du 0
term "low Moon: its refraction" --flattening off

view=
scene 2011-06-15T20:13:00Z --atmosphere undated $(off --scattered-light) $(off --starlight)
term "deep eclipse: scattered light" --scattered-light on
term "deep eclipse: starlight" --starlight on

cat <<'EOF'
Made by `tests/measurements/term_sizes.sh`: what each term of the physics changes when the flag beside it takes it away (or puts
it in), all else as in the atmosphere `undated`. What the terms of the month's air change: [`eclipse_brightness.md`](../../examples/eclipse_brightness.md).

Light in stops, log₂ of changed over standard, on neutral ground that faces the Sun: luminance (CIE Y) and blue (CIE Z;
the blue of Rec.709 would be below 0 in much of the umbra), on the shadow's axis, half way (2300 km) and just inside the
umbra's edge (4400 km); none for a term that acts after the shadow. The picture: CIEDE2000 over the Moon's disc, mean
and 99th percentile, of two stills developed at the exposure that suits the standard. The eclipse of 21 February 2008 at
03:26 UTC from Clifton Park, New York; low Moon: the same from where it stands 5° high; deep eclipse: 15 June 2011 at
20:13 UTC from the Earth's centre.

| term and flag | axis, Y | Z | half way, Y | Z | edge, Y | Z | ΔE mean | 99 % |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
EOF
sort -t '|' -k 9,9gr "$scratch/rows"
"$here/../../examples/made_at.sh" "tests/measurements/term_sizes.sh $given"
