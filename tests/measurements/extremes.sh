#!/bin/sh
# SPDX-License-Identifier: MIT
# What was pushed how far and what held: extremes.md on stdout, from what the tests of tests/extremes print. Ten
# minutes on two processors, then hours of ten thousand random recipes, and of fuzzers (package clang).
#
# Given  SHARDS=100         of 100 recipes each; 0: recipes and fuzzers stand as on the page beside this script
#        SECONDS_EACH=3600  of each fuzzer
set -eu
here=$(cd "$(dirname "$0")" && pwd)
shards=${1:-100} seconds_each=${2:-3600}
made_at() { "$here/../../examples/made_at.sh" "tests/measurements/extremes.sh $*"; }
"$here/../../examples/build.sh" "coppermoon_program quick_tests heavy_tests slow_tests sweep_tests" packages.tests.debian >&2
tests=$here/../../build/release/tests

# Folders of the tests' own, of new names each time.
nameless='s,[^ `("]*/coppermoon\(_\| test \)[A-Za-z0-9]\{6\}/\(here/\|tmp/\)\{0\,1\},,g; s,coppermoon-[A-Za-z0-9]\{6\}/,,g'

# rows TEST…: what they tried, and whether all of it held.
rows() {
  printf '| tried | held | bound | worst |\n| --- | --- | ---: | ---: |\n'
  for noun; do
    case $noun in faults | inputs | words) kind=heavy ;; film_faults) kind=slow ;; *) kind=quick ;; esac
    COPPERMOON_THOROUGH=1 "$tests/extremes_${kind}_tests" $noun --gtest_brief=1 > "$scratch" ||
      echo "extremes/$noun: failed" >&2
    sed -n '/^|/p' "$scratch" | sed "$nameless"
  done
}
heading() { printf '\n## %s\n\n' "$1"; }
scratch=$(mktemp)
trap 'rm -f "$scratch"' EXIT

cat <<'EOF'
# Pushed to the extremes

Made by `tests/measurements/extremes.sh` from what the tests in `tests/extremes` print: what was tried, what held, the bound that
the test asserts and the worst that was seen; or that it is refused, and the line that says so.

![](stability.svg)
EOF
heading "Numbers"
rows numbers numbers_of_light numbers_of_scenes
heading "Invariances"
rows invariances
heading "Inputs"
rows inputs
heading "Faults"
rows faults film_faults
heading "Untrusted words"
rows words
if [ "$shards" -eq 0 ]; then
  made_at "$shards"
  echo
  sed -n '/^## Random recipes/,$p' "$here/extremes.md"
  exit
fi
made_at "$shards" "$seconds_each"
heading "Random recipes"
printf '| tried | valid files | refused in one line | most memory of one [MB] |\n| --- | ---: | ---: | ---: |\n'
filter=$(seq -s : -f '*/%g' 0 $((shards - 1)))
"$tests/extremes_sweep_tests" --gtest_brief=1 --gtest_filter="$filter" > "$scratch" || echo "extremes_sweep_tests: failed" >&2
sed -n 's/^| random recipes [0-9]* to \([0-9]*\) | \([0-9]*\) valid files, \([0-9]*\) refused in one line, \([0-9]*\) MB .*/\1 \2 \3 \4/p' "$scratch" |
  awk '{ last = $1 + 1; files += $2; lines += $3; if ($4 > most) most = $4 }
       END { printf "| the first %d | %d | %d | %d |\n", last, files, lines, most }'
heading "Fuzzers"
"$here/../fuzz.sh" "$seconds_each" | sed -n '/^|/p'
made_at "$shards" "$seconds_each"
