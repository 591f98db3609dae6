#!/bin/sh
# SPDX-License-Identifier: MIT
# How far steps and rays may be pushed: measures stability.csv, here, and makes stability.svg beside this script
# again, in half a minute.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/../../examples/build.sh" stability packages.tests.debian
"$here/../../build/release/tests/measurements/stability" > stability.csv
gnuplot -c /dev/stdin stability.csv "$here/stability.svg" <<'EOF'
set terminal svg size 1500,900 font 'sans,13' background 'white'
set output ARG2
set datafile separator ','
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set grid lc rgb '#dddddd'
array colours[6] = ['#0072b2', '#d55e00', '#009e73', '#000000', '#cc79a7', '#56b4e9']
row(panel, line) = sprintf("< grep '^%s,%s,' %s", panel, line, ARG1)
set multiplot layout 2,2 title 'Relative error: the paper''s air, 550 nm'
set xrange [0.7:1.5e5]
set yrange [1e-13:1]
set xlabel 'step [m]'
ways = '"literal" "literal with gradients over 0.1 m"'
set key bottom right
do for [panel in '"bending" "optical depth" "light on the axis"'] {
  set title panel
  plot for [k = 1:2] row(panel, word(ways, k)) using 3:4 with linespoints lw 1.5 pt 2*k+3 ps 0.6 \
    lc rgb colours[k] title word(ways, k)
  unset key
}
set xrange [5e-7:2e3]
set yrange [1e-16:10]
set xlabel 'distance from the place [m]'
places = '"over the ground" "under the tropopause" "under a cloud deck" "under the taper corner" "under the top" "light beside the axis"'
set key top right
set title 'bending, exact rays'
plot for [k = 1:6] row('exact', word(places, k)) using 3:4 with linespoints lw 1.5 pt 2*k+3 ps 0.6 \
  lc rgb colours[k] title word(places, k)
EOF
