#!/bin/sh
# SPDX-License-Identifier: MIT
# Scenes written by hand, each with the Moon by moon.inc or coppermoon.inc: bakes its textures, renders it, develops it, and leaves
# gallery_landscape.png, gallery_sequence.png and gallery_ring.png in the current folder.
#
# Each is rendered twice as large and made smaller when it is developed, since an edge beside a light a thousand times as
# bright as white is smooth in the picture alone.
#
# Given  --width W, --height H  of the pictures, else 1920 x 1080
set -eu
here=$(cd "$(dirname "$0")" && pwd)
width=1920 height=1080
while [ $# -gt 0 ]; do
  case $1 in
    --width) width=$2 ;;
    --height) height=$2 ;;
    *) echo "gallery.sh: $1, allowed --width W --height H" >&2; exit 2 ;;
  esac
  shift 2
done
"$here/../build.sh" coppermoon_program packages.tests.debian
coppermoon=$here/../../build/release/coppermoon
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# moon NAME INSTANT PLACE: the texture moon_NAME.exr, dimmed and reddened by the air over the place; and on stdout how the
# Moon is turned and where it stands, as the parameters of Coppermoon_In_Sky begin.
moon() {
  "$coppermoon" scene "$2" --at "$3" --texture-width 360 -o "$scratch/$1" >&2
  mv "$scratch/$1/moon_lin_rec709.exr" "$scratch/moon_$1.exr"
  "$coppermoon" sky "$2" --at "$3" | awk '{ is[$1] = $2 } END {
    printf "{%s, %s, %s, %s, %s, %s}", is["sub_observer_latitude_deg"], is["sub_observer_longitude_deg"],
           is["axis_position_angle_deg"], is["parallactic_angle_deg"], is["altitude_deg"], is["azimuth_deg"] }'
}

# picture NAME FLAGS…: renders NAME.pov and develops it with these flags into gallery_NAME.png.
picture() {
  name=$1
  shift
  cp "$here/$name.pov" "$here/../../povray_scenes/coppermoon.inc" "$scratch"
  (cd "$scratch" && povray "+I$name.pov" "+O$name.exr" +FE "+W$((2 * width))" "+H$((2 * height))" +A0.0 +AM2 +R2 -J -D -V 2>log) ||
    { cat "$scratch/log" >&2; exit 1; }
  "$coppermoon" develop "$scratch/$name.exr" -o "$scratch/$name.png" "$@"
  oiiotool --nosoftwareattrib "$scratch/$name.png" --resize:filter=box "${width}x$height" -d uint8 -o "gallery_$name.png"
}

"$coppermoon" scene 2018-07-27T21:24:00Z --at 53.07,-4.08 --texture-width 360 -o "$scratch/night" >&2
mv "$scratch/night/moon.inc" "$scratch/night/eclipse_stars.inc" "$scratch"/night/*.exr "$scratch"
picture landscape --view "ACES 1.0 SDR Video" --f-number 2 --iso 800 --time 1

{
  echo "#declare Moons = array[13][6] {"
  for i in 00 01 02 03 04 05 06 07 08 09 10 11 12; do
    instant=$(date -u -d "2022-05-16T01:36Z +$((12 * ${i#0})) minutes" +%Y-%m-%dT%H:%MZ)
    turned=$(moon "sequence_$i" "$instant" 41.88,-87.62)
    echo "  $turned,"
  done
  echo "}"
} >"$scratch/sequence.inc"
picture sequence --view Filmic --f-number 4 --iso 400 --time 1

# The strip in ten-thousandths: POV-Ray reads no more than 65504.
"$coppermoon" ring 2018-07-27T20:05Z --on 8,-80 --earth sphere --scale 1e-4 -o "$scratch/ring.exr" |
  awk '{ is[$1] = $2 } END {
    printf "#declare Earth_Altitude = %s;\n#declare Inner_Angle = %s;\n#declare Outer_Angle = %s;\n",
           is["earth_altitude"], is["inner_angle"], is["outer_angle"]
    printf "#declare Zenith_Angle = %s;\n#declare Sun_Angle = %s;\n", is["zenith_position_angle"], is["sun_position_angle"] }' \
    >"$scratch/ring.inc"
picture ring --view Filmic --f-number 2 --iso 1600 --time 0.4
