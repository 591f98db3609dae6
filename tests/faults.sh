#!/bin/sh
# SPDX-License-Identifier: MIT
# Plants faults in a copy of the sources, one at a time, and runs the quick tests of the faulty stage alone:
#
#   tests/faults.sh             all faults
#   tests/faults.sh FOLDER …    those of these folders or files, as baker/shadow
#   tests/faults.sh --apply     whether each changes its line and has a name of its own, and no more
#
# A fault stands in the sources, above the line that it changes, where "old" first occurs: // FAULT name: old => new
# Prints each fault as caught or SURVIVES; one at which the tests do not end in ten minutes is caught. Exits 1 where one
# survives, no longer applies or does not compile. The copy stays in build/faults, for the next time.
set -eu
cd "$(dirname "$0")/.."
. tests/planting.sh

# A fault in a line: its file, its name.
listed() {
  grep -rHo --include=*.cpp --include=*.h '// FAULT .*' "$@" | sed 's|^\([^:]*\):// FAULT \([^:]*\): .*|\1 :: \2|' | LC_ALL=C sort
}
file_of() { printf '%s\n' "${1%% :: *}"; }
name_of() { printf '%s\n' "${1#* :: }"; }

# planted FILE NAME: prints the file with a fault in the first line below its marker that is no marker.
planted() {
  FAULT="// FAULT $2: " awk '
    /^ *\/\/ FAULT / {
      if (at = index($0, ENVIRON["FAULT"])) {
        pair = substr($0, at + length(ENVIRON["FAULT"]))
        arrow = index(pair, " => ")
        old = substr(pair, 1, arrow - 1)
        due = arrow > 1
      }
      print
      next
    }
    due {
      due = 0
      if (at = index($0, old)) $0 = substr($0, 1, at - 1) substr(pair, arrow + 4) substr($0, at + length(old))
    }
    { print }' "$1"
}

if [ "${1:-}" = --apply ]; then
  all=$(listed baker colour povray_scenes)
  twice=$(printf '%s\n' "$all" | sed 's/.* :: //' | sort | uniq -d)
  [ -z "$twice" ] || { printf 'tests/faults.sh: named twice: %s\n' "$twice" >&2; exit 1; }
  printf '%s\n' "$all" | {
    stale=0
    while read -r fault; do
      if planted "$(file_of "$fault")" "$(name_of "$fault")" | cmp -s - "$(file_of "$fault")"; then
        echo "tests/faults.sh: does not apply: $fault" >&2
        stale=1
      fi
    done
    exit "$stale"
  }
  exit
fi
[ $# -gt 0 ] || set -- baker colour povray_scenes
for folder; do
  [ -n "$(listed "$folder")" ] || { echo "tests/faults.sh $folder: no fault there" >&2; exit 1; }
done
faults=$(listed "$@")

prepare $(printf '%s\n' "$faults" | sed 's|/[^/]* :: .*||' | sort -u)

# what_of FILE NAME: prints what became of a fault.
what_of() {
  planted "$1" "$2" >"$copy/$1"
  if cmp -s "$1" "$copy/$1"; then echo "DOES NOT APPLY"; else verdict "$1"; fi
}

printf '%s\n' "$faults" | {
  count=0 caught=0
  while read -r fault; do
    file=$(file_of "$fault")
    name=$(name_of "$fault")
    result=$(what_of "$file" "$name")
    printf '%-8s  %s: %s\n' "$result" "$file" "$name"
    count=$((count + 1))
    [ "$result" != caught ] || caught=$((caught + 1))
  done
  printf '%d of %d faults caught\n' "$caught" "$count"
  [ "$caught" = "$count" ]
}
