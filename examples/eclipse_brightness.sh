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
Made by `examples/eclipse_brightness.sh`. This page compares measured eclipses with computed ones, in the air of their
month (`--atmosphere standard`) and in the air that was standard until version 0.1 (`undated`, the same at all places
and times). Nothing is fitted to any of them, except in the section on `calibrated`. Differences are observed minus
computed.

## The whole Moon at greatest eclipse, by instruments

The magnitudes are visual. No citable measurement in B was at hand.

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

Two fits were made to these five eclipses and the umbra of 2022 (below), each eclipse counted once. The first fits a
factor on the chance of cloud. The second also fits a factor on the free troposphere's aerosol. Each eclipse is compared
with the fit to the five others. With two factors, each can compensate for the other, up to the limits of what was
tried. The air `calibrated` therefore uses the factor on cloud alone, fitted to all six.

END
data_of() { echo "$data/$1.csv"; }
"$here/../build/release/tests/measurements/calibration" "$(data_of photometers)" "$(data_of umbra_profile)"
printf '\nNo fit used the observers of the next section. Their differences are: rms %s in `standard`, %s in `calibrated`.\n' \
  "$(of_observers standard)" "$(of_observers calibrated)"
cat <<'END'

## By observers

Observers of the same eclipse differ by 0.5 to 0.7 magnitudes.

| eclipse | umbral magnitude | quantity and source | observed | computed | difference | `undated` |
| --- | ---: | --- | ---: | ---: | ---: | ---: |
END
rows eclipse_photometry | while IFS=, read -r date quantity value uncertainty; do
  row "$date" "$quantity" "$value" "$(words_of "$quantity" "H. C. Vital")${uncertainty:+ ± $uncertainty}"
done | with_mean
three() { eclipse "$1"; V "$greatest" $flags; }
dark=$(three 2025-09-07)
printf '\nOne camera, with one exposure for each eclipse, shows 2025-09-07 some 0.75 mag fainter than 2018-01-31 and 2022-11-08. The\ncomputed differences are %s and %s, and their stated errors are 0.35 and 0.4.\n' \
  "$(minus "$dark" "$(three 2018-01-31)")" "$(minus "$dark" "$(three 2022-11-08)")" | sed 's/ -\([0-9]\)/ −\1/g'
cat <<'END'

H. C. Vital predicts the brightness from umbral magnitude alone, based on observers' estimates of earlier eclipses, each
accurate to 0.4 magnitudes. The table compares each prediction with an eclipse of that umbral magnitude:

| eclipse | umbral magnitude | foretold for | foretold | computed | difference | `undated` |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
END
rows brightness_trend | while IFS=, read -r date umbral_magnitude value; do
  row "$date" seen "$value" "$umbral_magnitude"
done | with_mean
cat <<'END'

## Across the umbra, by a camera

The eclipse of 16 May 2022 came four months after an eruption in the tropics (Hunga). The table gives the difference in
irradiance, in linear Rec.709, by distance from the axis. Differences are in magnitudes, positive if the photograph is
brighter. The scale of the photograph is accurate to some 0.2 mag, and its shape to better; the camera's own contrast is
not known.

END
umbra=$here/../build/release/tests/measurements/umbra
"$umbra" "$data/umbra_profile.csv" profile
cat <<'END'

The next table combines all these differences, with one choice changed at a time. The mean depends on the photograph's
scale and on the eruption, whose aerosol is known as a global mean for the month, and in bands only by judgement. The
scatter about the mean depends on the shape of the shadow.

END
"$umbra" "$data/umbra_profile.csv" choices
cat <<'END'

## Eclipses that chroniclers called dark

These eclipses are computed with the stratosphere's aerosol of their month, from ice cores. The neighbour is a total
eclipse of similar depth in a year without an eruption. Dates are in the Gregorian calendar, which `coppermoon` uses
throughout.

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

All computed eclipses but one are dark, by 2.3 to 3.6 magnitudes relative to their neighbours, because the ice records
an eruption before each. The computed eclipse of 1229 is not dark, because the ice records no eruption before it.
Whatever darkened the real one (weather along the limb, or an eruption too small to appear in polar snow) is not part of
a month's air.
END
"$here/made_at.sh" "examples/eclipse_brightness.sh $*"
