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

Made by \`examples/paper_figures.sh\`: Figures 1, 4, 5, 6 and 7 of Yapo & Cutler (2009) at their instants, exposures
and α, each from one simulation that is developed at every exposure asked for. All from Clifton Park, New York
(42.86° N, 73.77° W), through 127 mm f/12.1 at ISO 800, in the paper's air and with its lunar surface
([\`first_eclipse.toml\`](first_eclipse.toml)); celestial north up, east to the left. The paper's photographs are in
the paper.

Danjon's scale, and where the paper means to show it:

| L | how the eclipse looks | figure, α [m⁻¹] |
| --- | --- | --- |
| 4 | orange to copper, brighter than any other; the shadow's edge glows, somewhat blue | 5 and 6: 0; all of 7: 0 |
| 3 | the red of bricks, often with a yellow border | |
| 2 | rust; the shadow's middle nearly black, its outer parts much brighter | 5 and 6: 4.7e-6 |
| 1 | a dark brown or grey in which the maria are hard to find | 5 and 6: 1e-5 |
| 0 | hardly to be found in the sky when the eclipse is deepest | |

In the tables: the disc's mean luminance [cd/m²] and V magnitude above the observer's air, and L as observers
estimate it at such a magnitude, by \`coppermoon brightness FRAME.exr --json\` (in totality alone; magnitude knows
no colour); how far the Moon's centre is from the shadow's axis, by \`coppermoon sky INSTANT --json\`; the part of
the disc of which a channel is white, by \`oiiotool PICTURE.png --rangecheck 0 0.998\`. At ISO 800 and f/12.1, 22
cd/m² saturate in a second.

## Figure 1: no air, air that only refracts, all of it

![](pictures/figure_1.png)

$before_totality, $(axis $before_totality) from the axis, eleven minutes before totality; no dust. Above 1/4 s,
below 4 s.

| air | luminance | V | white at 1/4 s | at 4 s |
| --- | ---: | ---: | ---: | ---: |
| none, with starlight | $(measured no_air "0.25 4") |
| refraction alone | $(measured refraction "0.25 4") |
| all | $(measured all "0.25 4") |

Without air the umbra has the stars' light alone, darker than any L, and is black. Bent light makes it grey, and so
bright that 4 s lose all of it. Rayleigh scattering and ozone take most of that and leave the copper.

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

The paper uses its model's default α here and does not say which. We take 4.7e-6: it is the paper's middle value,
the one that is not round, thus chosen to fit something; and by it the whole Moon has V = −2.7 in mid-eclipse, where
observers saw −2.8 ± 0.3 (H. C. Vital, REA Brazil).

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

No dust: L 4. By \`coppermoon almanac\` second contact is at 07:40:49, with Chauvenet's shadow at 07:40:24; greatest
eclipse at 08:16:58.

| instant | phase | from the axis | exposure [s] | luminance | V | white |
| --- | --- | ---: | ---: | ---: | ---: | ---: |
| $1 | partial, a quarter outside the umbra | $(axis "$1") | 0.8 | $(measured "$1" 0.8) |
| $2 | 28 s before second contact | $(axis "$2") | 1.0 | $(measured "$2" 1.0) |
| $3 | deepest | $(axis "$3") | 1.5 | $(measured "$3" 1.5) |

## What differs from the paper, and why
EOF
cat <<'EOF'

* Misprints are put right: Cauchy's equation (4) is 1.000272643 + 1.2288/λ² + 3.555e4/λ⁴, four times the dispersion
  of the printed one; 0.0102963 stands in the denominator of (14), Δl in (12); α is per metre.
* The light is integrated by quadrature, in 60 bands, instead of by 10⁷ photons of 200 wavelengths: without grain,
  in half a second. With `--solver photons --photons 1e6` these luminances are by photons: up to 3 %
  larger without dust, 5 % with light dust and 10 % with heavy, since the recipe smooths photons by 100 km. Nor is a
  ray bent by the one-sided difference of (3), which bends it 0.06 % too little.
* Exposure is absolute: a pixel is white where ISO 12232 says that the sensor saturates. How its exposures were
  scaled, the paper does not say; nor how much ozone its one filter holds (345 DU here), nor when its Figure 1 is,
  and how exposed: here when a last crescent is sunlit in all three, and at two exposures, since none suits all.
* Cloud is left out, as in the paper. To 10 km over 70 % of the limb (`--cloud-cover 0.7 --cloud-top-km 10`) it
  would take 0.3 mag of V and 0.6 of R from mid-eclipse without dust. `--atmosphere standard` has it.
* Dust that is grey and lies from 15 to 20 km does not make Danjon's darker kinds. By `coppermoon shadow
  2008-02-21T03:26:00Z --atmosphere paper --dust-extinction 1e-5 --axis-distances 0,3500,4500` it takes 80 % of the
  light on the shadow's axis, 93 % at 3500 km, but 50 % at 4500 km (550 nm), by the umbra's edge, where the light
  passes above it and is white. So each kind is darker than the one before, and 2.5 mag are between the first and
  the last in mid-eclipse (03:26), where L by magnitude is 4.0, 3.1 and 2.4; but the last is a dim copper with a
  pale rim, not grey.
* The Moon's map is coppermoon's own.

`tests/end_to_end/paper_figures_test.cpp` asserts, in small, the order of brightness, the copper, and which parts
saturate: those of which so much of the Sun is in view.
EOF
"$here/made_at.sh" "examples/paper_figures.sh $given"
