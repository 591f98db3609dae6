#!/bin/sh
# SPDX-License-Identifier: MIT
# Pictures of README.md, docs/ and as_seen.md that no other script makes, in place: docs/pictures/*.jpg, examples/pictures/telescope.png
# and as_seen_*.jpg. Ten minutes.
#
# Given  NAME …  of pictures, as start_greatest dome; without: all
set -eu
here=$(cd "$(dirname "$0")" && pwd)
pages=$here/../docs/pictures
. "$here/parts.sh"
"$here/build.sh" "coppermoon_program coppermoon_python coppermoon_blender" packages.tests.debian \
  packages.hand_off.debian
PATH=$(cd "$here/../build/release" && pwd):$PATH
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"; end_parts' EXIT
cd "$scratch"

# picture NAME SIZE FILE OPTIONS…: of oiiotool, into docs/pictures.
picture() {
  name=$1 size=$2 file=$3
  shift 3
  oiiotool --nosoftwareattrib "$file" "$@" --resize:filter=box "$size" -d uint8 --compression jpeg:88 \
    -o "$pages/$name.jpg"
}

telescope() { coppermoon still --recipe "$here/telescope.toml" -o "$here/pictures/telescope.png"; }

start_greatest() {
  coppermoon still 2018-07-27 --at Nairobi -o moon.png
  picture start_greatest 600x400 moon.png
}

start_partial() {
  coppermoon still 2018-07-27 U1+26min --at Nairobi -o partial.png
  picture start_partial 600x400 partial.png
}

animate_try() {
  coppermoon still 2018-07-27 U2+10min --at Nairobi --width 960 --height 540 -o try.png
  picture animate_try 600x338 try.png
}

chase_map() {
  coppermoon night 2026-03-03 --at Honolulu --danjon-spread off -o map.png
  picture chase_map 800x0 map.png --cut 1190x560+10+60
}

chase_camera() {
  coppermoon still 2026-03-03 U2+10min --at Honolulu --camera 400mm --field 0.9 --iso 800 -o auto.png
  picture chase_camera 600x400 auto.png
}

glow() {
  for share in "--glow 0" ""; do
    coppermoon still "2018-07-27 U2-20min" --at Nairobi --camera schmidt-cassegrain --field 0.9 --time 1/4 $share \
      -o "glow$share.png"
  done
  labelled "glow--glow 0.png" "without glow"
  labelled glow.png "with the camera's glow"
  picture glow 904x300 "glow--glow 0.png" --resize:filter=box 450x300 glow.png --resize:filter=box 450x300 \
    --mosaic:pad=4 2x1
}

composite() {
  coppermoon animate 2018-07-27 --at Nairobi --from U1+14min --to U2+12min --frames 6 --time composite --width 240 \
    --height 240 --contact-sheet sheet.png -o composite
  picture composite 816x0 sheet.png
}

# labelled FILE TEXT: FILE with a label in its upper left corner.
labelled() {
  oiiotool --nosoftwareattrib "$1" --text:x=18:y=42:size=26:font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf:color=0.9,0.9,0.9 \
    "$2" -o "$1"
}

# half_dome NAME MOMENT PLACE FLAGS…: the sky above the horizon, developed.
half_dome() {
  name=$1 moment=$2 place=$3
  shift 3
  coppermoon dome "$moment" --at "$place" -o "$name.exr"
  oiiotool "$name.exr" --cut 2048x512+0+0 -o "half_$name.exr"
  coppermoon develop "half_$name.exr" "$@" -o "$name.png"
}

# Before the eclipse and in totality, one exposure.
dome() {
  half_dome before "2018-07-27 P1" Nairobi --time 10 --f-number 2 --iso 800
  half_dome totality "2018-07-27 greatest" Nairobi --time 10 --f-number 2 --iso 800
  labelled before.png "before the eclipse"
  labelled totality.png "in totality"
  picture dome 1920x968 before.png totality.png --mosaic:pad=8 1x2
}

povray_lake() {
  coppermoon scene 2018-07-27 U4-40min --at 52.9,-3.9 --texture-width 360 -o lake
  cp "$here/gallery/lake.pov" lake
  (cd lake && povray lake.pov +W3840 +H2160 +FE +A0.0 +AM2 +R2 -J -D -V 2>log) || { cat lake/log >&2; exit 1; }
  coppermoon develop lake/lake.exr --time 2 --f-number 4 --iso 1600 --view Filmic -o lake.png
  picture povray_lake 1920x1080 lake.png
}

# What one would see (examples/as_seen.md): pictures of a moment, of skies, and of a film.
as_seen() (
  pages=$here/pictures
  for seen in "berlin 2025-09-07T18:40Z Berlin" "sydney 2022-11-08T09:19Z Sydney" "honolulu 2026-03-03T11:14Z Honolulu" \
    "tokyo 2021-05-26T09:55Z Tokyo"; do
    # shellcheck disable=SC2086
    set -- $seen
    coppermoon still "$2" --at "$3" -o "$1.png"
    picture "as_seen_$1" 960x640 "$1.png"
  done
  for seen in "3 15:20" "6 15:43" "9 16:06" "12 16:27"; do
    # shellcheck disable=SC2086
    set -- $seen
    half_dome "sun_$1" "2028-12-31T$2Z" Berlin
    labelled "sun_$1.png" "the Sun $1 degrees down"
  done
  picture as_seen_skies 1280x0 sun_3.png sun_6.png sun_9.png sun_12.png --mosaic:pad=8 1x4
  coppermoon animate 2025-09-07 --at Berlin --up zenith --frames 9 --width 960 --height 640 -o film
  picture as_seen_film 1448x320 film/frame.0001.png --resize:filter=box 480x320 film/frame.0005.png --resize:filter=box 480x320 \
    film/frame.0009.png --resize:filter=box 480x320 --mosaic:pad=4 3x1
)

umbra() {
  PYTHONPATH=$here/../build/release/python /usr/bin/python3 "$here/python/umbra.py" umbra.png
  picture umbra 990x935 umbra.png --ch R,G,B
}

# The page in a browser, with the air and the light at a place shown.
explore() {
  coppermoon explore 2018-07-27 --at Nairobi -o page.html
  cat >>page.html <<'END'
<script>
addEventListener('load', () => setTimeout(() => {
  const page = [...document.querySelectorAll('*')].find((part) => part.shadowRoot).shadowRoot;
  for (const part of page.querySelectorAll('details'))
    part.open = ['The Earth’s air', 'Light at a place'].includes(part.querySelector('summary').textContent);
  const moon = page.querySelector('canvas'), {left, top} = moon.getBoundingClientRect();
  moon.dispatchEvent(new PointerEvent('pointermove', {clientX: left + 394, clientY: top + 292, bubbles: true}));
}, 500));
</script>
END
  chromium-headless-shell --no-sandbox --disable-gpu-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader \
    --disable-background-networking --no-first-run --hide-scrollbars --user-data-dir="$scratch/browser" --window-size=1280,800 \
    --virtual-time-budget=20000 --screenshot=page.png "file://$scratch/page.html#t=2018-07-27T19:40:00Z&up=zenith" 2>browser.log
  picture explore 1280x800 page.png --ch R,G,B
}

# in_blender WORDS…: Blender with the add-on, and with nothing of the user's.
in_blender() {
  mkdir -p scripts/addons
  (cd scripts/addons && cmake -E tar xf "$here/../build/release/coppermoon_blender.zip")
  env -u OCIO TMPDIR=/tmp LIBGL_ALWAYS_SOFTWARE=1 BLENDER_USER_SCRIPTS="$scratch/scripts" BLENDER_USER_CONFIG="$scratch/config" \
    XDG_CACHE_HOME="$scratch/cache" "$@" >blender.log 2>&1 || { cat blender.log >&2; exit 1; }
}

# A window of a screen that nobody sees; the wheel over the sidebar turns its tabs to the add-on's.
blender() {
  cat >window.py <<'END'
import bpy
from coppermoon.operators import Running

bpy.context.preferences.view.show_splash = False


def steps():
    window = bpy.context.window_manager.windows[0]
    bpy.ops.coppermoon.add_eclipse('EXEC_DEFAULT', date='2018-07-27', place='Nairobi', up='zenith')
    while Running.now:
        yield
    area = next(area for area in window.screen.areas if area.type == 'VIEW_3D')
    space = area.spaces[0]
    space.show_region_ui, space.overlay.show_overlays, space.shading.type = True, False, 'RENDERED'
    space.region_3d.view_perspective, window.scene.cycles.preview_samples = 'CAMERA', 64
    for _ in range(10):
        yield
    bar = next(region for region in area.regions if region.type == 'UI')
    tabs = {'x': bar.x + bar.width - 12, 'y': bar.y + bar.height - 100}
    for event in [('MOUSEMOVE', 'NOTHING')] * 2 + [('WHEELDOWNMOUSE', 'PRESS')] * 3:
        window.event_simulate(*event, **tabs, ctrl=event[1] == 'PRESS')
        for _ in range(3):
            yield
    window.event_simulate('MOUSEMOVE', 'NOTHING', x=400, y=300)
    for _ in range(120):
        yield
    bpy.ops.screen.screenshot(filepath='window.png')


work = steps()


def tick():
    with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
        if next(work, 'done') == 'done':
            bpy.ops.wm.quit_blender()
    return 0.2


bpy.app.timers.register(tick, first_interval=1)
END
  in_blender xvfb-run -a -s "-screen 0 1600x1000x24" timeout 300 blender --factory-startup --enable-event-simulate \
    --window-geometry 0 0 1600 1000 --addons coppermoon -P window.py
  picture blender 1156x0 window.png --ch R,G,B --cut 1321x824+0+82
}

blender_sky() {
  cat >sky.py <<'END'
import math

import bpy
from mathutils import Vector, noise

for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
scene = bpy.context.scene
scene.render.resolution_x, scene.render.resolution_y = 3840, 2160
eye = bpy.data.objects.new('Eye', bpy.data.cameras.new('Eye'))
scene.collection.objects.link(eye)
scene.camera, eye.location.z, eye.rotation_mode = eye, 2, 'QUATERNION'
eye.data.angle = math.radians(19)  # before the stars, which are two pixels wide
bpy.ops.coppermoon.add_eclipse(date='2018-07-27', contact='U2', offset=-600, place='Budapest', own_scene=False, night=True)
towards = bpy.data.objects['Moon'].matrix_world.translation.normalized()
towards.z = math.sin(math.radians(4.2))
eye.rotation_quaternion = towards.to_track_quat('-Z', 'Y')
# a plain of 40 km with low hills
steps = 400
places = [(200 * (i - steps / 2), 200 * (j - steps / 2)) for j in range(steps) for i in range(steps)]
heights = [200 * min(1, math.hypot(x, y) / 8000) * noise.fractal(Vector((x / 5000, y / 5000, 0)), 1, 2, 6) for x, y in places]
plain = bpy.data.meshes.new('Plain')
plain.from_pydata([(x, y, z) for (x, y), z in zip(places, heights)], [], [
    (k, k + 1, k + steps + 1, k + steps) for k in range(steps * (steps - 1)) if k % steps < steps - 1])
plain.polygons.foreach_set('use_smooth', [True] * len(plain.polygons))
earth = bpy.data.materials.new('Earth')
earth.use_nodes = True
earth.node_tree.nodes['Principled BSDF'].inputs['Base Color'].default_value = (0.18, 0.16, 0.11, 1)
earth.node_tree.nodes['Principled BSDF'].inputs['Specular'].default_value = 0
plain.materials.append(earth)
scene.collection.objects.link(bpy.data.objects.new('Plain', plain))
scene.render.engine, scene.cycles.samples, scene.cycles.use_denoising = 'CYCLES', 8, False
scene.render.image_settings.file_format, scene.render.image_settings.color_depth = 'OPEN_EXR', '32'
END
  in_blender blender -b --factory-startup --python-exit-code 3 --addons coppermoon -P sky.py -o "$scratch/sky.####" -f 1
  # the sunlit limb is a hundred times as bright as white: it has smooth edges where pixels are merged after white is cut
  coppermoon develop sky.0001.exr --time 1.5 --f-number 4 --iso 800 -o sky.png
  picture blender_sky 1920x1080 sky.png
}

names="telescope start_greatest start_partial animate_try chase_map chase_camera glow composite dome povray_lake as_seen umbra
explore blender blender_sky"
[ $# -gt 0 ] || set -- $names
for name; do
  echo $names | tr ' ' '\n' | grep -qx -e "$name" ||
    { echo "examples/pictures.sh $name: is no picture, allowed are" $names >&2; exit 2; }
  part "$name"
  "$name"
done
