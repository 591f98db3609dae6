#!/bin/sh
# SPDX-License-Identifier: MIT
# The paper's Figure 5 with its three kinds of dust, and its Figure 1: no air, air that only refracts, all of it.
# Further flags go to `coppermoon still`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh"
still() { "$here/../build/release/coppermoon" still --recipe "$here/first_eclipse.toml" "$@"; }
still --dust-extinction 0 -o figure_5_no_dust.png "$@"
still --dust-extinction 4.7e-6 -o figure_5_dust.png "$@"
still --dust-extinction 1e-5 -o figure_5_heavy_dust.png "$@"
figure_1="--solver quadrature --dust-extinction 0 --instant 2008-02-21T02:50:00Z"
still $figure_1 --atmosphere none --limb-darkening off --time 0.25 -o figure_1_no_air.png "$@"
still $figure_1 --rayleigh off --ozone-du 0 --time 0.25 -o figure_1_refraction.png "$@"
still $figure_1 --time 4 -o figure_1_all.png "$@"
