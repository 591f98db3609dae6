#!/bin/sh
# SPDX-License-Identifier: MIT
# What was pushed how far and what held: extremes.md on stdout, from what the tests of tests/extremes print. Ten
# minutes on two processors, and then hours of ten thousand random recipes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh" all >&2
tests=$here/../build/release/tests

# rows TEST…: what they tried, and whether all of it held.
rows() {
  printf '| tried | held | bound | worst |\n| --- | --- | ---: | ---: |\n'
  for noun; do
    "$tests/extremes_${noun}_test" --gtest_brief=1 > "$scratch" || echo "extremes_${noun}_test: failed" >&2
    sed -n '/^|/p' "$scratch"
  done
}
heading() { printf '\n## %s\n\n' "$1"; }
scratch=$(mktemp)
trap 'rm -f "$scratch"' EXIT

cat <<'EOF'
# Pushed to the extremes

Made by `examples/extremes.sh` from what the tests in `tests/extremes` print: what was tried, what held, the bound that
the test asserts and the worst that was seen; or that it is refused, and the line that says so.

![](pictures/stability.svg)
EOF
heading "Numbers"
rows numbers numbers_of_light numbers_of_scenes
heading "Invariances"
rows invariances
heading "Inputs"
rows inputs
heading "Faults"
rows faults
heading "Untrusted words"
rows words
heading "Ten thousand random recipes"
rows sweep
