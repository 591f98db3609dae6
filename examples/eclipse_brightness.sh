#!/bin/sh
# SPDX-License-Identifier: MIT
# Eclipses as they were measured and as they are computed: eclipse_brightness.md on stdout.
# Flags, as --cloud-cover 0.5, go to `coppermoon brightness`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
data=$here/../tests/end_to_end/data
"$here/build.sh" "coppermoon_program umbra calibration" >&2

coppermoon() { "$here/../build/release/coppermoon" "$@" --json; }
number() { sed -n "s/.*\"$1\": \([-0-9.e]*\).*/\1/p"; }
V() { coppermoon brightness "$@" | number V; }
minus() { awk "BEGIN { printf \"%+.2f\", $1 - ($2) }"; }
flags=$*

# eclipse DATE: when it is greatest, and its umbral magnitude.
eclipse() {
  almanac=$(coppermoon almanac --from "$1" --to "$1T23:59:59Z")
  greatest=$(echo "$almanac" | sed -n 's/.*"greatest": "\(.*\)".*/\1/p')
  magnitude=$(echo "$almanac" | number umbral_magnitude)
}

# computed QUANTITY FLAGS: as the observer gave it.
computed() {
  quantity=$1
  shift
  eclipsed=$(V "$greatest" $flags "$@")
  case $quantity in
    seen) echo "$eclipsed" ;;
    dimming) awk "BEGIN { print $eclipsed - ($(V "$greatest" $flags "$@" --unshadowed)) }" ;;
    standard)
      sky=$(coppermoon sky "$greatest")
      awk "BEGIN { print $eclipsed + 5 / log(10) * (log(384400 / $(echo "$sky" | number moon_distance_km)) \
                   - log($(echo "$sky" | number sun_distance_au))) }" ;;
  esac
}

# row DATE QUANTITY VALUE WORDS: before in the air that was standard until version 0.1.
row() {
  eclipse "$1"
  before=$(computed "$2" --atmosphere undated)
  ours=$(computed "$2")
  printf '| %s | %.2f | %s | %s | %.2f | %s | %s |\n' "$1" "$magnitude" "$4" "$3" "$ours" \
    "$(minus "$3" "$ours")" "$(minus "$3" "$before")"
}

rows() { grep -v -e '^#' -e '^date' -e '^julian' "$data/$1.csv"; }

# with_mean: the table's rows, the mean of their differences and its root mean square, with a proper minus.
with_mean() {
  awk -F'|' '{ print; ours += $7; before += $8; ours2 += $7^2; before2 += $8^2 }
             END { printf "| mean | | | | | %+.2f | %+.2f |\n", ours / NR, before / NR
                   printf "| rms | | | | | %.2f | %.2f |\n", sqrt(ours2 / NR), sqrt(before2 / NR) }' |
    sed 's/ -\([0-9]\)/ −\1/g'
}

# of_observers ATMOSPHERE: root mean square over those that are no instruments.
of_observers() {
  rows eclipse_photometry | grep -v standard | while IFS=, read -r date quantity value _; do
    eclipse "$date"
    minus "$value" "$(computed "$quantity" --atmosphere "$1")"
    echo
  done | awk 'NF { sum += $1 * $1; ++n } END { printf "%.2f", sqrt(sum / n) }'
}

words_of() {
  case $1 in
    standard) echo "at standard distances, Hernitschek et al. (2008)" ;;
    seen) echo "as seen, H. C. Vital" ;;
    dimming) echo "below the full Moon, $2" ;;
  esac
}

cat <<'END'
Made by `examples/eclipse_brightness.sh`: eclipses as they were measured, and as they are computed in the air of their month
(`--atmosphere standard`) and in the air that was standard until version 0.1 (`undated`: alike everywhere and always). Nothing
is fitted to any of them, but in the section on `calibrated`. Differences are observed less computed.

## The whole Moon at greatest eclipse, by instruments

Visual magnitudes; of B no measurement that can be cited was at hand.

| eclipse | umbral magnitude | quantity and source | measured | computed | difference | `undated` |
| --- | ---: | --- | ---: | ---: | ---: | ---: |
END
rows photometers | while IFS=, read -r date quantity value uncertainty; do
  words=$(words_of "$quantity" Schmude)
  [ "$date" != 2014-04-15 ] || words="as seen, a photometer on Mauna Loa"
  row "$date" "$quantity" "$value" "$words ± $uncertainty"
done | with_mean
cat <<'END'

## One number fitted: `calibrated`

Factors on the chance of cloud, and on it and the free troposphere's aerosol, fitted to these five and the umbra of 2022
(below), each eclipse counted once. Each is judged by the fit to the five others. Two factors trade one for the other, up to
the end of what was tried: the air `calibrated` has the one on cloud, of all six.

END
data_of() { echo "$data/$1.csv"; }
"$here/../build/release/tests/measurements/calibration" "$(data_of photometers)" "$(data_of umbra_profile)"
printf '\nThe observers of the next section, whom no fit has seen: rms %s in `standard`, %s in `calibrated`.\n' \
  "$(of_observers standard)" "$(of_observers calibrated)"
cat <<'END'

## By observers

Observers of one and the same eclipse differ by 0.5 to 0.7 magnitudes.

| eclipse | umbral magnitude | quantity and source | observed | computed | difference | `undated` |
| --- | ---: | --- | ---: | ---: | ---: | ---: |
END
rows eclipse_photometry | while IFS=, read -r date quantity value uncertainty; do
  row "$date" "$quantity" "$value" "$(words_of "$quantity" "H. C. Vital")${uncertainty:+ ± $uncertainty}"
done | with_mean
three() { eclipse "$1"; V "$greatest" $flags; }
dark=$(three 2025-09-07)
printf '\nOne camera, with one exposure each, has 2025-09-07 some 0.75 mag fainter than 2018-01-31 and 2022-11-08; computed are\n%s and %s. The errors that we state of such differences are 0.35 and 0.4.\n' \
  "$(minus "$dark" "$(three 2018-01-31)")" "$(minus "$dark" "$(three 2022-11-08)")" | sed 's/ -\([0-9]\)/ −\1/g'
cat <<'END'

What H. C. Vital foretells from observers' estimates of earlier eclipses, each to 0.4 magnitudes, by umbral magnitude
alone; computed for an eclipse that has it:

| eclipse | umbral magnitude | foretold for | foretold | computed | difference | `undated` |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
END
rows brightness_trend | while IFS=, read -r date umbral_magnitude value; do
  row "$date" seen "$value" "$umbral_magnitude"
done | with_mean
cat <<'END'

## Across the umbra, by a camera

16 May 2022, four months after an eruption in the tropics (Hunga): irradiance in linear Rec.709 by distance from the axis, in
magnitudes, + where the photograph is brighter. Its scale is good to some 0.2 mag, its shape to better; the camera's own
contrast is not known.

END
umbra=$here/../build/release/tests/measurements/umbra
"$umbra" "$data/umbra_profile.csv" profile
cat <<'END'

The same all together, with one choice made otherwise at a time. The mean is a matter of the photograph's scale and of the
eruption, whose aerosol is known as global mean of the month and by judgement in bands; what is left about the mean is the
shape of the shadow.

END
"$umbra" "$data/umbra_profile.csv" choices
cat <<'END'

## Eclipses that chroniclers called dark

With the stratosphere's aerosol of their month, from ice cores; the neighbour is a total eclipse of like depth in a year
without an eruption. Dates are those of the Gregorian calendar, which `coppermoon` has throughout.

| eclipse | Julian date | aerosol's optical depth | V computed | `undated` | neighbour | its V | `undated` |
| --- | --- | ---: | ---: | ---: | --- | ---: | ---: |
END
depth_in() {
  awk -F, -v y="$1" '/^#/ { next } $1 + 0 >= y { print t + ($2 - t) * (y - x) / ($1 - x); exit } { x = $1; t = $2 }' \
    "$here/../baker/atmosphere/data/stratospheric_ice_cores.csv"
}
rows chronicles | while IFS=, read -r julian date neighbour; do
  eclipse "$date"
  dark=$(V "$greatest") dark_undated=$(V "$greatest" --atmosphere undated)
  year=$(echo "$date" | awk -F- '{ printf "%.3f", $1 + ($2 - 0.5) / 12 }')
  eclipse "$neighbour"
  printf '| %s | %s | %.3f | %.1f | %.1f | %s | %.1f | %.1f |\n' "$date" "$julian" "$(depth_in "$year")" "$dark" "$dark_undated" \
    "$neighbour" "$(V "$greatest")" "$(V "$greatest" --atmosphere undated)"
done | sed 's/ -\([0-9]\)/ −\1/g'
cat <<'END'

All but one come out dark, by 2.3 to 3.6 magnitudes against their neighbours: an eruption stands in the ice before each. That of
1229 does not: there is none in the ice, and what darkened it (weather along the limb, or an eruption too small for the
poles' snow) the air of a month does not know.
END
"$here/made_at.sh" "examples/eclipse_brightness.sh $*"
