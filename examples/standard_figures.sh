#!/bin/sh
# SPDX-License-Identifier: MIT
# Three eclipsed Moons in the air that is standard. Further flags go to `coppermoon still`.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh"
still() { "$here/../build/release/coppermoon" still --focal-length 1540 --sensor-width 22.7 "$@"; }
clifton_park="--at 42.86,-73.77"
set -- --width 750 --height 500 "$@"
still 2008-02-21T02:57:00Z $clifton_park --f-number 12 --iso 800 --time 2 -o standard_2008_rim.png "$@"
still 2008-02-21T03:26:00Z $clifton_park -o standard_2008_middle.png "$@"
still 2018-07-27T20:21:00Z -o standard_2018.png "$@"
