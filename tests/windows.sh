#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the archive for Windows on Debian 12, unpacks it into a folder with a blank and letters of two scripts in its name,
# and uses it there under Wine (windows_cases.sh). As root, with a network; some 40 minutes on two processors from nothing,
# ten where the libraries are made already. Prints the archive's size.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
sh examples/build.sh coppermoon_program packages.tests.debian packages.windows.debian
cmake --workflow --preset windows
archive=$root/$(ls build/windows/coppermoon-*.zip)
linux=$root/build/release/coppermoon

fresh=$(mktemp -d)
export WINEDEBUG=-all WINEPREFIX="$fresh/wine"
trap 'wineserver -k 2>/dev/null || true; rm -rf --one-file-system "$fresh"' EXIT
mkdir "$fresh/a folder, Ö 月"
cd "$fresh/a folder, Ö 月"
cmake -E tar xf "$archive"
folder=$PWD/$(ls)
windows=$folder/bin/coppermoon.exe
kilobytes=$(du -k "$archive" | cut -f1)
echo "$kilobytes kB as an archive, $(du -sk "$folder" | cut -f1) kB unpacked"
[ "$kilobytes" -le 30000 ] || { echo "the archive takes $kilobytes kB, allowed 30000"; exit 1; }
for file in share/coppermoon/coppermoon_blender.zip share/coppermoon/recipes share/zoneinfo/Africa/Nairobi \
  share/doc/coppermoon/docs/platforms.md share/doc/coppermoon/licences/openimageio/LICENSE.md; do
  [ -e "$folder/$file" ] || { echo "$file: is not in the archive"; exit 1; }
done
others=$(x86_64-w64-mingw32-objdump -p "$windows" | sed -n 's/.*DLL Name: //p' |
  grep -viE '^(kernel32|user32|gdi32|advapi32|shell32|ole32|bcrypt|psapi|ws2_32|msvcrt|dbghelp)\.dll$' || true)
[ -z "$others" ] || { echo "needs libraries that are not of Windows:" $others; exit 1; }

wine "$windows" --version | tr -d '\r' >version
"$linux" --version | cmp - version
"$root/tests/windows_cases.sh" "$linux" "$windows"
echo "unpacked, used, the same light"
