#!/bin/sh
# SPDX-License-Identifier: MIT
# How dark each total eclipse from 2000 to 2050 is: brightness_2000_2050.csv and .md, and pictures/brightness_2000_2050.png,
# in the current folder.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" coppermoon_program >&2
"$here/../build/release/coppermoon" almanac --from 2000-01-01 --to 2050-12-31 --brightness --csv |
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i }
           NR == 1 || $column["type"] == "total" {
             split($column["greatest"], when, "T")
             line = NR == 1 ? "date" : when[1]
             split("umbral_magnitude V_magnitude V_error danjon_by_V", names, " ")
             for (i = 1; i <= 4; ++i) line = line "," (NR == 1 ? names[i] : sprintf("%.2f", $column[names[i]]))
             print line }' >brightness_2000_2050.csv
mkdir -p pictures
gnuplot <<'END'
set terminal pngcairo size 1200,520 font "sans,13"
set output 'pictures/brightness_2000_2050.png'
set datafile separator ','
set xdata time
set timefmt '%Y-%m-%d'
set format x '%Y'
set xrange ['1999-06-01':'2051-06-01']
set yrange [3:-5]
set ylabel 'V of the whole Moon at greatest eclipse'
set grid
set key off
plot 'brightness_2000_2050.csv' every ::1 using 1:3:4 with yerrorbars pointtype 7 linecolor rgb '#b5502f'
END
{
  cat <<'END'
Made by `examples/brightness_2000_2050.sh`. The table gives the V magnitude of the whole Moon at the greatest phase of
each total eclipse from 2000 to 2050 in the air of its month, its standard error (68 of 100 eclipses lie within it) and
Danjon's L derived from V. From 2026 on, the stratosphere's aerosol is that of quiet years: a great eruption would
darken the eclipses of the following years by one to four magnitudes.

![V by year, with error bars](pictures/brightness_2000_2050.png)

| eclipse | umbral magnitude | V | ± | L |
| --- | ---: | ---: | ---: | ---: |
END
  awk -F, 'NR > 1 { printf "| %s | %s | %s | %s | %.1f |\n", $1, $2, $3, $4, $5 }' brightness_2000_2050.csv | sed 's/| -/| −/g'
  "$here/made_at.sh" "examples/brightness_2000_2050.sh $*"
} >brightness_2000_2050.md
