#!/bin/sh
# SPDX-License-Identifier: MIT
# What somebody types by nature: each command line below is answered by what was meant, or by one line that names the right
# one. Runs all in a new folder, prints what each says, and exits 1 where one ends otherwise or says something else.
# Five minutes on two processors.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
program=$root/build/release/coppermoon
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
export XDG_CONFIG_HOME="$folder/configuration" XDG_CACHE_HOME="$folder/cache"
mkdir -p bin there && ln -s "$program" bin/coppermoon
PATH="$folder/bin:$PATH"
coppermoon() { "$program" "$@"; }

small="--texture-width 64 --quality draft" still="--width 64 --height 64 --quality draft"
export small still
coppermoon bake 2018-07-27 $small -o moon.exr >/dev/null 2>&1
coppermoon still "2018-07-27 U1+30min" --at Nairobi --width 400 --height 400 --time 1/250 --quality draft -o moon.png --frame frame.exr \
  >/dev/null 2>&1
ln -s there/l.exr l.exr
/usr/bin/python3 "$root/tests/natural_files.py"

failed=0 count=0
# line STATUS PATTERN COMMAND: runs the command, prints what it says, and holds both to what is expected.
line() {
  count=$((count + 1))
  printf '\n$ %s\n' "$3"
  status=0
  said=$(sh -c "$3" 2>&1) || status=$?
  printf '%s\n' "$said" | cut -c -300 | head -n 25
  if [ "$status" != "$1" ] || ! printf '%s\n' "$said" | grep -qE -e "$2"; then
    printf '!! status %s, expected %s with: %s\n' "$status" "$1" "$2"
    failed=$((failed + 1))
  fi
}

while IFS='	' read -r status pattern command; do
  case $status in '' | '#'*) [ -z "$status" ] || printf '\n== %s\n' "${status#\# }" ;; *) line "$status" "$pattern" "$command" ;; esac
done <"$root/tests/natural_commands.txt"

printf '\n%d passed, %d failed\n' $((count - failed)) "$failed"
[ "$failed" = 0 ]
