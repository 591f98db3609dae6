#!/bin/sh
# SPDX-License-Identifier: MIT
# The paper's Figures 1, 4, 5, 6 and 7, each a strip in the current folder (figure_1.png …), and paper_figures.md, their
# page, on stdout. A minute.
#
# Given  FLAGS  of `coppermoon still`, as --width 150 --height 100, or --solver photons for the paper's way, an hour
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" >&2
results=$PWD
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
given=$*
flags="--solver quadrature --width 450 --height 300 $given"

coppermoon() { "$here/../build/release/coppermoon" "$@"; }

# frame NAME INSTANT FLAGS: light, texture and frame, all but the exposure.
frame() {
  name=$1 instant=$2
  shift 2
  # shellcheck disable=SC2086
  coppermoon still --recipe "$here/first_eclipse.toml" --instant "$instant" "$@" --sky off $flags \
    --frame "$name.exr" -o "$name.png" >&2
  coppermoon brightness "$name.exr" --json > "$name.json"
}

# pictures TIMES NAMES: a picture NAME_TIME.png of each frame at each time.
pictures() {
  times=$1
  shift
  for name in "$@"; do
    for time in $times; do
      coppermoon develop "$name.exr" --recipe "$name.exr" --time "$time" -o "${name}_$time.png" >&2
    done
  done
}

# strip FIGURE COLUMNSxROWS PICTURES: the middle of each, side by side.
strip() {
  figure=$1 shape=$2
  shift 2
  for picture in "$@"; do
    set -- "$@" "$picture.png" --cut "{TOP.height}x{TOP.height}+{(TOP.width-TOP.height)/2}+0"
    shift
  done
  oiiotool --nosoftwareattrib "$@" --mosaic:pad=4 "$shape" -o "$results/$figure.png"
}

# said NAME KEY: what `brightness --json` said of a frame.
said() { sed -n "s/.*\"$2\": \([^,]*\).*/\1/p" "$1.json"; }

# above FILE VALUE: how many pixels have a channel above that.
above() { oiiotool "$1" --rangecheck 0 "$2" | awk '/>/ { print $1 }'; }

# saturated NAME TIME: the part of the disc that is white in some channel, 255 of 255.
saturated() {
  awk -v white="$(above "$1_$2.png" 0.998)" -v disc="$(above "$1.exr" 1e-7)" \
    'BEGIN { printf "%.1f %%", 100 * white / disc }'
}

# measured NAME TIMES: mean luminance and magnitude, and what saturates at each time.
measured() {
  awk -v mean="$(said "$1" mean_luminance_cd_m2)" -v V="$(said "$1" V)" 'BEGIN { printf "%#.3g | %.2f", mean, V }'
  for time in $2; do printf ' | %s' "$(saturated "$1" "$time")"; done
}

# ratio NAME OTHER: of their mean luminances.
ratio() {
  awk -v one="$(said "$1" mean_luminance_cd_m2)" -v other="$(said "$2" mean_luminance_cd_m2)" \
    'BEGIN { printf "%.2f", one / other }'
}

# axis INSTANT: kilometres from the shadow's axis to the Moon's centre.
axis() { coppermoon sky "$1" --json | awk '/axis_distance_km/ { printf "%.0f km", $2 }'; }

no_dust="--dust-extinction 0"
before_totality=2008-02-21T02:50:00Z
# shellcheck disable=SC2086
{
  frame no_air $before_totality --atmosphere none --earth sphere --limb-darkening off --starlight on $no_dust
  frame refraction $before_totality --rayleigh off --ozone-du 0 $no_dust
  frame all $before_totality $no_dust
}
pictures "0.25 4" no_air refraction all
strip figure_1 3x2 no_air_0.25 refraction_0.25 all_0.25 no_air_4 refraction_4 all_4

partial=2008-02-21T04:12:44Z
exposures="0.008 0.050 0.166 0.500 1.509"
frame partial $partial --dust-extinction 4.7e-6
pictures "$exposures" partial
# shellcheck disable=SC2046
strip figure_4 5x1 $(printf 'partial_%s ' $exposures)

# dusts FIGURE INSTANT TIME: none, light, heavy.
dusts() {
  frame "$1_none" "$2" --dust-extinction 0
  frame "$1_light" "$2" --dust-extinction 4.7e-6
  frame "$1_heavy" "$2" --dust-extinction 1e-5
  pictures "$3" "$1_none" "$1_light" "$1_heavy"
  strip "$1" 3x1 "$1_none_$3" "$1_light_$3" "$1_heavy_$3"
}
early=2008-02-21T03:08:26Z late=2008-02-21T03:50:42Z
dusts figure_5 $early 4
dusts figure_6 $late 3

forecast="2010-12-21T07:22:17Z 2010-12-21T07:40:21Z 2010-12-21T08:16:56Z"
for instant in $forecast; do frame "$instant" "$instant" --dust-extinction 0; done
# shellcheck disable=SC2086
set -- $forecast
pictures 0.8 "$1"
pictures 1.0 "$2"
pictures 1.5 "$3"
strip figure_7 3x1 "${1}_0.8" "${2}_1.0" "${3}_1.5"

# exposure_row TIME WORDS
exposure_row() {
  awk -v t="$1" 'BEGIN { printf "| %s | %.0f |", t, 78 * 12.1 ^ 2 / (0.65 * 800 * t) }'
  echo " $(saturated partial "$1") | $2 |"
}

# dust_rows FIGURE TIME
dust_rows() {
  for row in "none 0 4" "light 4.7e-6 2" "heavy 1e-5 1"; do
    # shellcheck disable=SC2086
    set -- "$1" "$2" $row
    printf "| %s | %s | %s | %s | %.1f |\n" "$4" "$5" "$(measured "$1_$3" "$2")" "$(ratio "$1_$3" "$1_none")" \
      "$(said "$1_$3" danjon)"
  done
}

cat <<EOF
# The paper's figures, remade

Made by \`examples/paper_figures.sh\`. This page shows Figures 1, 4, 5, 6 and 7 of Yapo & Cutler (2009) at their instants,
exposures and α. Each comes from one simulation that is developed at every exposure. All are seen from Clifton Park, New
York (42.86° N, 73.77° W), through 127 mm f/12.1 at ISO 800, in the paper's air and with its lunar surface
([\`first_eclipse.toml\`](first_eclipse.toml)). Celestial north is up, and east to the left. The paper's photographs are
in the paper.

The table shows Danjon's scale, and the figures in which the paper illustrates it:

| L | how the eclipse looks | figure, α [m⁻¹] |
| --- | --- | --- |
| 4 | orange to copper, brighter than any other; the shadow's edge glows, somewhat blue | 5 and 6: 0; all of 7: 0 |
| 3 | the red of bricks, often with a yellow border | |
| 2 | rust; the shadow's middle nearly black, its outer parts much brighter | 5 and 6: 4.7e-6 |
| 1 | a dark brown or grey in which the maria are hard to find | 5 and 6: 1e-5 |
| 0 | hardly to be found in the sky when the eclipse is deepest | |

\`coppermoon brightness FRAME.exr --json\` gives the disc's mean luminance [cd/m²] and V magnitude above the observer's
air, and L as observers estimate it at such a magnitude (only in totality; magnitude says nothing about colour).
\`coppermoon sky INSTANT --json\` gives the distance of the Moon's centre from the shadow's axis. \`oiiotool PICTURE.png
--rangecheck 0 0.998\` gives the part of the disc in which a channel is white. At ISO 800 and f/12.1, 22 cd/m² saturate
in a second.

## Figure 1: no air, air that only refracts, all of it

![](pictures/figure_1.png)

$before_totality, $(axis $before_totality) from the axis, eleven minutes before totality, without dust. Upper row 1/4 s,
lower row 4 s.

| air | luminance | V | white at 1/4 s | at 4 s |
| --- | ---: | ---: | ---: | ---: |
| none, with starlight | $(measured no_air "0.25 4") |
| refraction alone | $(measured refraction "0.25 4") |
| all | $(measured all "0.25 4") |

Without air the umbra is lit only by the stars. The umbra is then darker than any L, and black. Bent light makes it
grey, and so bright that it is overexposed in 4 s. Rayleigh scattering and ozone remove most of that light and leave a
copper colour.

## Figure 4: one partial eclipse, five exposures

![](pictures/figure_4.png)

$partial, $(axis $partial) from the axis, 22 minutes after totality; α = 4.7e-6 m⁻¹. Luminance and V:
$(measured partial "" | sed 's/ |/,/').

| exposure [s] | white from [cd/m²] | white | what shows |
| --- | ---: | ---: | --- |
$(exposure_row 0.008 "the sunlit limb in all its shades; the umbra is black")
$(exposure_row 0.050 "the limb is burnt out; the umbra nearly black")
$(exposure_row 0.166 "so is most of the sunlit part; a first brown")
$(exposure_row 0.500 "the copper, beside a white crescent")
$(exposure_row 1.509 "the umbra to its darkest part, nothing of it white; a grey-blue fringe where it ends")

A fifth of the disc (21 %) is outside the umbra of an Earth without air.

The paper uses its model's default α here and does not say which. We take 4.7e-6, the paper's middle value. It is the
only value that is not round, so it was probably chosen to fit something. It also gives the whole Moon V = −2.7 in
mid-eclipse, for which observers reported −2.8 ± 0.3 (H. C. Vital, REA Brazil).

## Figure 5: early in totality, three kinds of dust

![](pictures/figure_5.png)

$early, $(axis $early) from the axis; 4.0 s.

| α [m⁻¹] | meant as L | luminance | V | white | of no dust's light | L by magnitude |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
$(dust_rows figure_5 4)

## Figure 6: the end of totality, three kinds of dust

![](pictures/figure_6.png)

$late, $(axis $late) from the axis, thirteen seconds before third contact; 3.0 s.

| α [m⁻¹] | meant as L | luminance | V | white | of no dust's light | L by magnitude |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
$(dust_rows figure_6 3)

## Figure 7: the eclipse that was to come

![](pictures/figure_7.png)

The figure shows air without dust, L 4. According to \`coppermoon almanac\`, second contact is at 07:40:49 (07:40:24 with
Chauvenet's shadow), and greatest eclipse at 08:16:58.

| instant | phase | from the axis | exposure [s] | luminance | V | white |
| --- | --- | ---: | ---: | ---: | ---: | ---: |
| $1 | partial, a quarter outside the umbra | $(axis "$1") | 0.8 | $(measured "$1" 0.8) |
| $2 | 28 s before second contact | $(axis "$2") | 1.0 | $(measured "$2" 1.0) |
| $3 | deepest | $(axis "$3") | 1.5 | $(measured "$3" 1.5) |

## What differs from the paper, and why
EOF
cat <<'EOF'

* Misprints are corrected. Cauchy's equation (4) is 1.000272643 + 1.2288/λ² + 3.555e4/λ⁴, with four times the dispersion
  of the printed one. The denominator of (14) contains 0.0102963, and (12) contains Δl. The unit of α is m⁻¹.
* The light is integrated by quadrature in 60 bands, in half a second and without grain, instead of by 10⁷ photons of
  200 wavelengths. Photons (`--solver photons --photons 1e6`) give luminances up to 3 % larger without dust, 5 % with
  light dust and 10 % with heavy dust, because the recipe smooths photons by 100 km. The rays are not bent by the
  one-sided difference of (3), which bends them 0.06 % too little.
* Exposure is absolute: a pixel is white if the sensor saturates according to ISO 12232. The paper does not say how its
  exposures were scaled, or how much ozone its one filter contains (345 DU here). It also gives neither the moment nor
  the exposure of its Figure 1. Here a last crescent is sunlit in all three pictures, and there are two exposures,
  because no single one suits all.
* Cloud is left out, as in the paper. Cloud up to 10 km over 70 % of the limb (`--cloud-cover 0.7 --cloud-top-km 10`)
  would make mid-eclipse without dust fainter by 0.3 mag in V and 0.6 mag in R. `--atmosphere standard` includes cloud.
* Grey dust from 15 to 20 km does not reproduce Danjon's darker eclipses. According to `coppermoon shadow
  2008-02-21T03:26:00Z --atmosphere paper --dust-extinction 1e-5 --axis-distances 0,3500,4500`, such dust removes 80 %
  of the light on the shadow's axis and 93 % at 3500 km (550 nm). Near the umbra's edge, at 4500 km, it removes only 50
  %, because the light there passes above the dust and is white. Each kind of dust is therefore darker than the one
  before, and the first and the last differ by 2.5 mag in mid-eclipse (03:26), with L by magnitude of 4.0, 3.1 and 2.4.
  The last, however, is a dim copper with a pale rim, not grey.
* The Moon's map is coppermoon's own.

`tests/end_to_end/paper_figures_test.cpp` checks small versions of these figures: the order of brightness, the copper
colour, and the parts that saturate, which follow from how much of the Sun is in view.
EOF
"$here/made_at.sh" "examples/paper_figures.sh $given"
