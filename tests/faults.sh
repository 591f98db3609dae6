#!/bin/sh
# SPDX-License-Identifier: MIT
# Plants faults in a copy of the sources, one at a time, and runs the quick tests of the faulty stage alone:
#
#   tests/faults.sh             all faults of tests/faults.txt
#   tests/faults.sh FOLDER …    those in files of these folders, as baker/shadow
#   tests/faults.sh --apply     whether each still changes its file, and no more
#
# Prints each fault as caught or SURVIVES; one at which the tests do not end in ten minutes is caught. Exits 1 where one
# survives, no longer applies or does not compile. The copy stays in build/faults, for the next time.
set -eu
cd "$(dirname "$0")/.."
list=$PWD/tests/faults.txt
copy=$PWD/build/faults/source
build=$PWD/build/faults/build

chosen() {
  [ $# -gt 0 ] || set -- ''
  for folder; do grep -v '^#' "$list" | grep "^$folder" || { echo "tests/faults.sh $folder: no fault there" >&2; exit 1; }; done
}

# What a fault is: its file, how it is planted, what is wrong then.
file_of() { printf '%s\n' "${1%% :: *}"; }
plant_of() { rest=${1#* :: } && printf '%s\n' "${rest%% :: *}"; }
harm_of() { printf '%s\n' "${1##* :: }"; }

if [ "${1:-}" = --apply ]; then
  grep -v '^#' "$list" | {
    stale=0
    while read -r fault; do
      file=$(file_of "$fault")
      if [ -f "$file" ] && ! sed "$(plant_of "$fault")" "$file" | cmp -s - "$file"; then continue; fi
      echo "tests/faults.txt: no longer applies: $fault"
      stale=1
    done
    exit "$stale"
  }
  exit
fi
faults=$(chosen "$@")

# Files that did not change keep their time: what was built before stays built.
mkdir -p "$copy"
git ls-files --cached --others --exclude-standard | while read -r file; do
  if [ ! -f "$file" ] || cmp -s "$file" "$copy/$file"; then continue; fi
  mkdir -p "$copy/$(dirname "$file")"
  cp "$file" "$copy/$file"
done

stages=$(printf '%s\n' "$faults" | sed 's|/[^/]* :: .*||' | sort -u)
target_of() { printf '%s_quick_tests\n' "$1" | tr / _; }
cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCOPPERMOON_STRICT=OFF >"$build.log" 2>&1 || {
  cat "$build.log" >&2
  exit 1
}
ninja -C "$build" $(for stage in $stages; do target_of "$stage"; done) >"$build.log" 2>&1 || {
  tail -n 30 "$build.log" >&2
  exit 1
}

for stage in $stages; do
  "$build/tests/$(target_of "$stage")" --gtest_brief=1 >"$build.log" 2>&1 || {
    cat "$build.log" >&2
    echo "tests/faults.sh $stage: its tests fail without a fault" >&2
    exit 1
  }
done

# Prints what became of a fault.
verdict() {
  sed -i "$2" "$copy/$1"
  if cmp -s "$1" "$copy/$1"; then echo "NO LONGER APPLIES"; return; fi
  target=$(target_of "${1%/*}")
  if ! ninja -C "$build" -j1 "$target" >"$build.log" 2>&1; then
    echo "DOES NOT COMPILE"
  elif GTEST_FAIL_FAST=1 GTEST_BRIEF=1 timeout 600 "$build/tests/$target" >"$build.log" 2>&1; then
    echo SURVIVES
  else
    echo caught
  fi
  cp "$1" "$copy/$1"
}

printf '%s\n' "$faults" | {
  count=0 caught=0
  while read -r fault; do
    file=$(file_of "$fault")
    result=$(verdict "$file" "$(plant_of "$fault")")
    printf '%-8s  %s: %s\n' "$result" "$file" "$(harm_of "$fault")"
    count=$((count + 1))
    [ "$result" != caught ] || caught=$((caught + 1))
  done
  printf '%d of %d faults caught\n' "$caught" "$count"
  [ "$caught" = "$count" ]
}
