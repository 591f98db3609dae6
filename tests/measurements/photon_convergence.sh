#!/bin/sh
# SPDX-License-Identifier: MIT
# Plots what photon_convergence measures, to the number of photons given (1e6: seven minutes on two processors). Fails where
# the error is not what the photons say: half to twice as large. Of 32 rings either is known within a fifth.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/../../examples/build.sh" photon_convergence packages.tests.debian
"$here/../../build/release/tests/measurements/photon_convergence" "${1:-1e6}" > photon_convergence.csv
awk -F, 'NR > 1 && ($3 > 2 * $4 || $3 < $4 / 2) { print "error, standard error: " $0; wrong = 1 }
  END { exit wrong || NR < 3 }' photon_convergence.csv
gnuplot <<'EOF'
set terminal pngcairo size 900,560
set output 'photon_convergence.png'
set datafile separator ','
set logscale xy
set xrange [7000:*]
set grid
set xlabel 'photons'
set ylabel 'relative error of a ring of 1000 km, 550 nm'
literal(column) = stringcolumn(1) eq 'literal' ? column : 1/0
table(column) = stringcolumn(1) eq 'table' ? column : 1/0
plot 'photon_convergence.csv' skip 1 using 2:(literal($3)) with linespoints lw 2 pt 7 title 'literal', \
     '' skip 1 using 2:(literal($4)) with lines lw 1 title 'standard error, as the photons say', \
     '' skip 1 using 2:(table($3)) with linespoints lw 2 pt 7 title 'by the table', \
     '' skip 1 using 2:(table($4)) with lines lw 1 title 'standard error, as the photons say', \
     0.3*sqrt(1000/x) with lines dashtype 2 title 'N^{-1/2}'
EOF
