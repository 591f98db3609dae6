#!/bin/sh
# SPDX-License-Identifier: MIT
# Whether plans keep what they promise: planned_runs.md on stdout. Half an hour on two processors.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/../../examples/build.sh" end_to_end_slow_tests packages.tests.debian >&2
cat <<'EOF'
Made by `tests/measurements/planned_runs.sh`: eclipses of 1990 to 2040 at random moments, under random air (preset, ozone, cloud,
tropospheric and stratospheric aerosol, dust, Danjon's scale), to a random tolerance from 10 to 0.01 %. The true error is
the largest of luminance at 60 random places of the disc, each against the quadrature of 2000 rays, 400 wavelengths and
all terms on a plane of its own; where the air has a region, at 12 places deep in a total eclipse of a spherical Earth.
EOF
for noun in planned_runs planned_regions; do
  "$here/../../build/release/tests/end_to_end_slow_tests" $noun --gtest_brief=1 || true
done |
  awk '/^\| random/ { print ""; print; print "| --- | ---: |"; next } /^\|/'
"$here/../../examples/made_at.sh" tests/measurements/planned_runs.sh
