#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the portable archive on Debian 12, unpacks it in a bare Debian 13 without a package, and uses it there. As root, with
# a network; some five minutes on two processors. Prints the archive's size and the seconds of a start.
set -eu
cd "$(dirname "$0")/.."
sh examples/build.sh coppermoon_program
apt-get install -y --no-install-recommends debootstrap binutils dpkg-dev >/dev/null
cmake --workflow --preset portable
archive=$(ls build/portable/coppermoon-*.tar.xz)

fresh=$(mktemp -d)
trap 'umount "$fresh/proc" 2>/dev/null || true; rm -rf --one-file-system "$fresh"' EXIT
debootstrap --variant=minbase trixie "$fresh" >/dev/null
mount -t proc proc "$fresh/proc"
tar -xf "$archive" -C "$fresh/opt"
folder=$(ls "$fresh/opt")
echo "$(du -k "$archive" | cut -f1) kB as an archive, $(du -sk "$fresh/opt/$folder" | cut -f1) kB unpacked"

newest=$(find "$fresh/opt/$folder" -type f \( -name '*.so*' -o -name coppermoon \) -exec objdump -T {} + 2>/dev/null |
  grep -o 'GLIBC_2[0-9.]*' | sort -uV | tail -1)
[ "$newest" = GLIBC_2.36 ] || { echo "needs $newest, allowed GLIBC_2.36"; exit 1; }

recipe="2018-07-27T20:00:00Z --albedo-map built-in --texture-width 256"
build/release/coppermoon bake $recipe -o build/portable/here.exr
dd if=/dev/urandom of="$fresh/tmp/noise.dcm" bs=1000 count=3 2>/dev/null
chroot "$fresh" env -i PATH="/opt/$folder/bin:/usr/bin:/bin" HOME=/tmp bash -euc "cd /tmp
  dpkg -l | awk '\$1 == \"ii\"' | wc -l
  time coppermoon --version
  time coppermoon bake $recipe -o there.exr
  coppermoon develop there.exr -o there.png
  coppermoon shadow 2018-07-27T20:00:00Z >shadow.txt
  coppermoon night 2018-07-27 --at Nairobi | grep EAT
  ! coppermoon develop noise.dcm -o noise.png 2>refused
  grep 'not read by the portable archive' refused"
cmp build/portable/here.exr "$fresh/tmp/there.exr"
echo "unpacked, used, the same bytes"
