#!/bin/sh
# SPDX-License-Identifier: MIT
# Plots what photon_convergence measures, to the number of photons given (1e6: seven minutes on two processors).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" photon_convergence
"$here/../build/release/examples/photon_convergence" "${1:-1e6}" > photon_convergence.csv
gnuplot <<'EOF'
set terminal pngcairo size 900,560
set output 'photon_convergence.png'
set datafile separator ','
set logscale xy
set xrange [700:*]
set grid
set xlabel 'photons'
set ylabel 'relative error of a ring of 1000 km, 550 nm'
plot 'photon_convergence.csv' skip 1 using 1:2 with linespoints lw 2 pt 7 title 'against the quadrature', \
     '' skip 1 using 1:3 with lines lw 2 title 'standard error, as the photons say', \
     0.3*sqrt(1000/x) with lines dashtype 2 title 'N^{-1/2}'
EOF
