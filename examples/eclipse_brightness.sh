#!/bin/sh
# SPDX-License-Identifier: MIT
# Eclipses as they were measured and as they are computed: eclipse_brightness.md on stdout.
# Flags, as --cloud-cover 0.5, go to `coppermoon brightness`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
data=$here/../tests/end_to_end/data
"$here/build.sh" >&2

coppermoon() { "$here/../build/release/coppermoon" "$@" --json; }
number() { sed -n "s/.*\"$1\": \([-0-9.]*\).*/\1/p"; }
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

# row DATE QUANTITY VALUE WORDS
row() {
  eclipse "$1"
  ours=$(computed "$2")
  built_in=$(computed "$2" --albedo-map built-in --texture-width 512)
  printf '| %s | %.2f | %s | %s | %.2f | %s | %s |\n' "$1" "$magnitude" "$4" "$3" "$ours" \
    "$(minus "$3" "$ours")" "$(minus "$3" "$built_in")"
}

rows() { grep -v -e '^#' -e '^date' "$data/$1.csv"; }

# with_mean: the table's rows and the mean of their differences, with a proper minus.
with_mean() {
  awk -F'|' '{ print; ours += $7; built_in += $8 }
             END { printf "| mean | | | | | %+.2f | %+.2f |\n", ours / NR, built_in / NR }' |
    sed 's/ -\([0-9]\)/ −\1/g'
}

cat <<'END'
Made by `examples/eclipse_brightness.sh`: the whole Moon at greatest eclipse, visual magnitudes, observed and computed.
The air is the same each time, `--atmosphere standard`; no year's volcanoes, no day's weather. Observers of one and the
same eclipse differ by 0.5 to 0.7 magnitudes. Difference: observed less computed.

| eclipse | umbral magnitude | quantity and source | observed | computed | difference | with the built-in Moon |
| --- | ---: | --- | ---: | ---: | ---: | ---: |
END
rows eclipse_photometry | while IFS=, read -r date quantity value; do
  case $quantity in
    standard) words="at standard distances, Hernitschek et al. (2008)" ;;
    seen) words="as seen, H. C. Vital" ;;
    dimming) words="below the full Moon, H. C. Vital" ;;
  esac
  row "$date" "$quantity" "$value" "$words"
done | with_mean
cat <<'END'

What H. C. Vital foretells from observers' estimates of earlier eclipses, each to 0.4 magnitudes, by umbral magnitude
alone; computed for an eclipse that has it:

| eclipse | umbral magnitude | foretold for | foretold | computed | difference | with the built-in Moon |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
END
rows brightness_trend | while IFS=, read -r date umbral_magnitude value; do
  row "$date" seen "$value" "$umbral_magnitude"
done | with_mean
