#!/bin/sh
# SPDX-License-Identifier: MIT
# Plants forty mutations in a copy of the stages' sources, one at a time: one operator or one number of a random place is
# another (tests/mutations.py). The quick tests of the stage alone run.
#
#   tests/mutations.sh [--seed N] [STAGE …]    all stages; another seed each time, which is printed
#
# All but baker/files, whose tests write files and end processes. Prints each mutation as caught or SURVIVES. Those that do
# not compile, or compile to the same object code, are not counted, and others drawn. Exits 1 where fewer than 85 % are
# caught.
set -eu
cd "$(dirname "$0")/.."
. tests/planting.sh
counted=40 least=85 drawn=100

seed=$(od -An -N3 -tu4 /dev/urandom | tr -d ' ')
if [ "${1:-}" = --seed ]; then seed=$2; shift 2; fi
[ $# -gt 0 ] || set -- baker/algebra baker/almanac baker/atmosphere baker/eclipse baker/photons baker/plan \
  baker/shadow baker/surface baker/texture colour povray_scenes
echo "seed $seed"
prepare "$@"
mutated=$(mktemp -d)
trap 'rm -rf "$mutated"' EXIT
python3 tests/mutations.py "$seed" "$drawn" "$mutated" "$@" >"$mutated/list"

# code_of FILE: compiles a file of the copy and prints the sum of its objects; fails where it does not compile.
code_of() {
  objects=$(cd "$build" && find "${1%/*}" -path "*.dir/${1##*/}.o")
  ninja -C "$build" -j1 $objects >"$build.log" 2>&1 && (cd "$build" && cat $objects | cksum)
}

tab=$(printf '\t')
number=0 count=0 caught=0
while [ "$count" -lt "$counted" ] && IFS=$tab read -r file change line; do
  number=$((number + 1))
  before=$(code_of "$file")
  cp "$mutated/$number" "$copy/$file"
  result="same program"
  if ! after=$(code_of "$file"); then
    result="does not compile"
    cp "$file" "$copy/$file"
  elif [ "$after" = "$before" ]; then
    cp "$file" "$copy/$file"
  else
    result=$(verdict "$file")
    count=$((count + 1))
    [ "$result" != caught ] || caught=$((caught + 1))
  fi
  printf '%-8s  %s:%s    %s\n' "$result" "$file" "$change" "$line"
done <"$mutated/list"
printf '%d of %d mutations caught\n' "$caught" "$count"
[ "$count" -gt 0 ] && [ $((100 * caught)) -ge $((least * count)) ]
