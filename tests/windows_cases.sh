#!/bin/sh
# SPDX-License-Identifier: MIT
# What the program for Windows does under Wine, held to what the program for Linux does.
#
#   tests/windows_cases.sh LINUX WINDOWS
#
# Runs each command line below with both, in two folders, and compares all that they write (windows_same.py). Then tries
# what is of Windows alone: names, paths, consoles, texts, kills. Exits 1 where anything is otherwise.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
linux=$(realpath "$1") windows=$(realpath "$2")
export LC_ALL=C.UTF-8 WINEDEBUG=-all
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/here" "$work/there Ö 月"
there="$work/there Ö 月"
when=2018-07-27T20:00:00Z
export COPPERMOON_CACHE=cache
failed=0
wrong() { echo "!! $*"; failed=$((failed + 1)); }
run() { wine "$windows" "$@"; }

# both COMMAND: what both say on standard output goes to the file N.txt, N.csv or N.json of their folders.
count=0
both() {
  count=$((count + 1))
  ending=txt
  case $* in *--json*) ending=json ;; *--csv*) ending=csv ;; esac
  (cd "$work/here" && eval "\"$linux\" $*" >"$count.$ending" 2>messages) || wrong "here: $* $(cat "$work/here/messages")"
  (cd "$there" && eval "wine \"$windows\" $*" >"$count.$ending" 2>messages) || wrong "$* $(cat "$there/messages")"
}

"$linux" still $when --at Nairobi --width 300 --height 200 --quality draft --time 2 -o "$work/here/photograph.png" 2>/dev/null
cp "$work/here/photograph.png" "$there"
quick="--texture-width 128 --quality draft"
for ending in exr tx png jpg tif dng glb usda usdz; do
  "$linux" bake $when $quick -o "$work/try.$ending" >/dev/null 2>&1 || continue  # not a format of textures
  both bake $when $quick -o moon.$ending
done
for threads in 1 2 5; do (cd "$there" && TBB_NUM_THREADS=$threads run bake $when $quick -o threads_$threads.exr >/dev/null 2>&1); done
cmp "$there/threads_1.exr" "$there/threads_5.exr" && cmp "$there/threads_1.exr" "$there/threads_2.exr" || wrong "other threads, other bytes"
both scene $when --at Nairobi $quick -o scene
both shader 2018-07-27 --quality draft -o shader
both night 2018-07-27 --at Nairobi
both night 2018-07-27 --at Nairobi -o night.ics
both night 2018-07-27 --at Nairobi -o night.json
both almanac 2026 --json
both almanac --from 2020-01-01 --to 2030-01-01 -o almanac.csv
both brightness $when --at Nairobi --quality draft --json
both dome $when --at Nairobi --width 128 --quality draft -o dome.exr
both ring $when --on Tycho -o ring.exr
both develop moon.exr --time 1 -o developed.png
both explore 2018-07-27 --at Nairobi -o explore.html
both plan $when --quality draft --json
both describe --json
both shadow $when --quality draft
both animate 2018-07-27 --from U2 --to U3 --frames 3 --at Nairobi $quick --make textures --stage film/stage.usda -o film
both bake moon.exr -o again.exr  # the recipe in a header is read back
both bake moon.exr -o "'Ö 月 again.exr'"
both fit photograph.png --instants from-header --at Nairobi --json

/usr/bin/python3 "$here/windows_same.py" "$work/here" "$there" || wrong "not the light of Linux"
cd "$there"

# refused PATTERN COMMAND …: it ends with status 1 or 2, and one line.
refused() {
  pattern=$1 status=0
  shift
  run "$@" 2>said >/dev/null || status=$?  # by a file, since Wine's own programs keep a pipe open
  said=$(grep -v "at work for" said || true)
  case $status in 1 | 2) ;; *) wrong "status $status: $*" ;; esac
  [ "$(printf '%s\n' "$said" | grep -c .)" = 1 ] && printf '%s\n' "$said" | grep -q "$pattern" || wrong "$*: $said"
}
bake="bake $when $quick"
for name in CON.exr nul.exr a:b.exr 'moon.exr.' 'moon.exr ' 'a?.exr' 'no/aux/moon.exr'; do
  refused "Windows does not allow\|ends in" $bake -o "$name"
done
refused 'no such directory' $bake -o 'C:\nowhere\moon.exr'
printf '\377\376' >utf16.toml
printf 'ozone = 1\n' | iconv -t UTF-16LE >>utf16.toml
refused 'utf16.toml: text in UTF-16, allowed UTF-8' $bake --recipe utf16.toml -o no.exr

printf '\357\273\277ozone-factor = 1.1\r\n' >windows.toml
run $bake --recipe windows.toml -o 'Z:'"$(echo "$there/by drive.exr" | tr / '\\')" >/dev/null 2>&1 || wrong "a recipe of Windows"
[ -s "by drive.exr" ] || wrong "no file by drive and backslashes"
long=$(printf 'long_%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24)
mkdir -p "$long/$long/$long"
run $bake -o "$long/$long/$long/moon.exr" >/dev/null 2>&1 && cmp moon.exr "$long/$long/$long/moon.exr" || wrong "a long path"

# Killed at any time, it leaves files that are whole, and no others; two films do not share a folder.
film="animate 2018-07-27 --from U1 --to U4 --frames 40 --at Nairobi $quick --make textures -o killed"
for seconds in 2 3 4; do
  wine "$windows" $film >/dev/null 2>&1 &
  child=$!
  sleep $seconds
  kill -9 $child 2>/dev/null || true  # it may have ended
  wait $child 2>/dev/null || true
done
wine "$windows" $film >/dev/null 2>&1 &
child=$!
sleep 3
refused 'killed' $film --danjon 1
wait $child || wrong "a film goes on"
sleep 2
[ -z "$(find . -name '*.tmp')" ] || wrong "left: $(find . -name '*.tmp')"
(cd "$work/here" && "$linux" $film >/dev/null 2>&1)
/usr/bin/python3 "$here/windows_same.py" "$work/here/killed" killed || wrong "a killed film is another"

# Programs beside it: missing, and found on the path.
refused 'povray: not found; install' still $when --at Nairobi --width 64 --height 64 $quick -o still.png
refused 'gnuplot: not found; install' night 2018-07-27 --at Nairobi -o map.png

mkdir "$work/bin ü"
cat >"$work/fake.c" <<'C'
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <windows.h>
int main(int count, char** words) {  /* copies FAKE_RESULT to the file after +O, or to standard output */
  const char* name = NULL;
  FILE* said = fopen(getenv("FAKE_SAID"), "wb");
  for (int i = 1; i < count; ++i) {
    fprintf(said, "%s ", words[i]);
    if (strncmp(words[i], "+O", 2) == 0) name = words[i] + 2;
  }
  FILE *from = fopen(getenv("FAKE_RESULT"), "rb"), *to = name ? fopen(name, "wb") : stdout;
  if (!name) setmode(1, 0x8000);
  for (int c; (c = fgetc(from)) != EOF;) fputc(c, to);
  return fclose(to) || fclose(said);
}
C
x86_64-w64-mingw32-gcc-posix -w "$work/fake.c" -o "$work/bin ü/gnuplot.exe"
cp "$work/bin ü/gnuplot.exe" "$work/bin ü/pvengine64.exe"
"$linux" still $when --at Nairobi --width 64 --height 64 $quick -o "$work/still.png" --frame frame.exr >/dev/null 2>&1
mv frame.exr "$work"
export FAKE_SAID="Z:$work/said.txt" FAKE_RESULT="Z:$work/still.png" WINEPATH="Z:$work/bin ü"
run night 2018-07-27 --at Nairobi -o map.png >/dev/null 2>&1 || wrong "no map by gnuplot"
grep -q '^-d plot.gp' "$work/said.txt" && cmp map.png "$work/still.png" || wrong "gnuplot was told $(cat "$work/said.txt")"
FAKE_RESULT="Z:$work/frame.exr" run still $when --at Nairobi --width 64 --height 64 $quick -o still.png \
  >/dev/null 2>&1 || wrong "no still by pvengine64"
grep -q '^/EXIT /RENDER eclipse.ini +Oframe' "$work/said.txt" || wrong "POV-Ray was told $(cat "$work/said.txt")"

printf '\n%d command lines with both; %d wrong\n' "$count" "$failed"
[ "$failed" = 0 ]
