#!/bin/sh
# SPDX-License-Identifier: MIT
# How to add a term of the air, a number of a result, a camera's response, a city, a map's encoding and an output format, as worked
# examples that run: plants one of each in a copy of the sources, builds the program, and shows that it has them without any other edit: the term,
# `volcanic-glass`, in flags, help, completions, recipes, `describe`, random recipes, the fuzzers' words and docs/recipes.md; the
# number, `planted_mlx`, in --json, in Python with its docstring and stub, pickled, and in docs/results.md.
# Exits 1 where something lacks one, or where one needs more edits than are allowed here. The copy stays in build/planted,
# for the next time.
set -eu
cd "$(dirname "$0")/.."
copy=$PWD/build/planted
edits=0 files=

# Files that did not change keep their time: what was built before stays built.
new=$(mktemp -d)
scratch=$(mktemp -d)
trap 'rm -rf "$new" "$scratch"' EXIT
git ls-files --cached --others --exclude-standard | while read -r file; do
  [ ! -f "$file" ] || cp --parents "$file" "$new"
done

# edited FILE: it becomes what the scratch folder holds, and is counted.
edited() {
  cp "$scratch/edited" "$new/$1"
  edits=$((edits + 1))
  case " $files " in *" $1 "*) ;; *) files="$files $1" ;; esac
}

# edit FILE LINE TEXT: an edit, TEXT behind the one line that holds LINE.
edit() {
  [ "$(grep -cF "$2" "$new/$1")" = 1 ] || { echo "$1: \"$2\" does not stand in one line" >&2; exit 1; }
  line="$2" text="$3" awk '{ print } index($0, ENVIRON["line"]) { print ENVIRON["text"] }' "$new/$1" >"$scratch/edited"
  edited "$1"
}

# swap FILE OLD NEW: an edit, NEW in the place of OLD, which stands in one line.
swap() {
  [ "$(grep -cF "$2" "$new/$1")" = 1 ] || { echo "$1: \"$2\" does not stand in one line" >&2; exit 1; }
  old="$2" put="$3" awk '{ at = index($0, ENVIRON["old"])
    if (at) $0 = substr($0, 1, at - 1) ENVIRON["put"] substr($0, at + length(ENVIRON["old"])); print }' "$new/$1" >"$scratch/edited"
  edited "$1"
}

# counted WHAT EDITS FILES: says how many edits WHAT took, and exits 1 beyond those allowed.
counted() {
  count=$(echo $files | wc -w)
  echo "$1: $edits edits in $count files:$files"
  [ "$edits" -le "$2" ] && [ "$count" -le "$3" ] || { echo "$1: allowed $2 edits in $3 files" >&2; exit 1; }
  edits=0 files=
}

# The air: what a column holds, whether it is sound, and what the term does to light.
edit baker/atmosphere/atmosphere.h 'double tropospheric_optical_depth = 0;' \
  '  double volcanic_glass = 0;  ///< grey vertical optical depth of glass among that aerosol, 0 to 10; 0: off'
edit baker/atmosphere/atmosphere.cpp '"tropospheric scale height [m]"' \
  '  algebra::require_within("volcanic glass", column.volcanic_glass, 0, 10);'
swap baker/atmosphere/atmosphere.cpp 'return c.tropospheric_optical_depth > 0;' \
  'return c.tropospheric_optical_depth + c.volcanic_glass > 0;'
swap baker/atmosphere/atmosphere.cpp 'return c.tropospheric_optical_depth * tropospheric_spectrum(' \
  'return c.volcanic_glass + c.tropospheric_optical_depth * tropospheric_spectrum('
# The request: its field, how it changes a column, and its description.
edit baker/uses/light/air.h 'std::optional<double> tropopause_km{};' \
  '  std::optional<double> volcanic_glass{};'
edit baker/uses/light/air.cpp 'change.tropospheric_optical_depth.value_or(column.tropospheric_optical_depth);' \
  '  column.volcanic_glass = change.volcanic_glass.value_or(column.volcanic_glass);'
edit baker/uses/light/light_parameters.cpp 'auto& stratosphere = column.stratosphere;' \
  '  is.add(parameter("volcanic-glass", column.volcanic_glass,
                   "vertical optical depth of volcanic glass near the ground, 0 to 10"))
      .within(0, 10);'

counted 'term of the air' 9 8

# A result: its number, what that is, and how it is found.
edit baker/uses/picture/brightness.h 'std::optional<BrightnessSeen> seen = {};' \
  '  double planted_mlx = 0;'
edit baker/uses/picture/brightness.h 'describe_light(is, brightness.disc);' \
  '  is("planted_mlx", brightness.planted_mlx, algebra::Unit{"mlx"}, "planted illuminance");'
edit baker/uses/picture/brightness.cpp 'MoonBrightness brightness{sky.when,' \
  '  brightness.planted_mlx = 1e3 * brightness.disc.illuminance_lx;'
counted 'number of a result' 3 3

# A camera's response: its three columns in the table, here copies of the first, and its name on the page of cameras.
awk -F, '/^#/ { print; next } !named { named = 1; print $0 ",planted-camera_r,planted-camera_g,planted-camera_b"; next }
  { print $0 "," $2 "," $3 "," $4 }' "$new/colour/data/camera_spectra.csv" >"$scratch/edited"
edited colour/data/camera_spectra.csv
swap docs/cameras.md '`fujifilm-x-t3` (measured' '`fujifilm-x-t3` and `planted-camera` (measured'
counted "camera's response" 2 2

# A city: its row.
edit baker/almanac/data/cities.csv 'Shanghai,Shanghai,' 'Planted City,Nowhere,12.34,56.78,9,Asia/Dubai'
counted 'city' 1 1

# An encoding of maps: its name, how its numbers are read and decoded, and what the page says of it.
edit baker/uses/picture/moon.h 'cgi_moon_kit_2025,  ///<' '  planted_map,  ///< sRGB'
edit baker/uses/picture/moon.cpp 'std::vector<Decoding> decodings{' \
  '    {{"planted-map", AlbedoEncoding::planted_map, "sRGB"}, texture::Coding::srgb, as_it_is},'
edit docs/textures.md '| `cgi-moon-kit-2025` |' '| `planted-map` | a planted one | sRGB is undone |'
counted "map's encoding" 3 3

# An output format of pictures: its function, and its row in the table.
edit baker/uses/picture/picture_files.cpp 'namespace fs = std::filesystem;' '
void write_as_ppm(const fs::path& file, const ShownPicture& picture) {
  texture::write_picture(file, picture.layout, picture.rows, {"pnm", 8}, picture.attributes);
}'
swap baker/uses/picture/picture_files.cpp 'true, write_as_avif}};' \
  'true, write_as_avif}, PictureFile{{".ppm", "planted"}, false, write_as_ppm}};'
counted 'output format' 2 1

(cd "$new" && find . -type f) | while read -r file; do
  if cmp -s "$new/$file" "$copy/$file"; then continue; fi
  mkdir -p "$copy/$(dirname "$file")"
  cp "$new/$file" "$copy/$file"
done
cd "$copy"
export CCACHE_BASEDIR="$copy"
{ cmake --preset release && cmake --build build/release --target coppermoon_program coppermoon_python coppermoon_manual_pages extremes_heavy_tests; } \
  >build.log 2>&1 || { tail -n 30 build.log >&2; exit 1; }
program=$copy/build/release/coppermoon

# has WHAT TEXT: whether standard input holds the text.
has() {
  grep -qF -e "$2" || { echo "$1: without $2" >&2; exit 1; }
  echo "$1"
}
$program bake --help-all | has 'help' '--volcanic-glass NUMBER'
has 'manual page' 'volcanic\-glass' <build/release/manuals/coppermoon-bake.1
has 'completions' 'volcanic-glass' <build/release/manuals/coppermoon.bash
$program describe --json | has 'describe' '"name": "volcanic-glass"'
$program describe --json | tests/fuzz/dictionary.py recipe tests/fuzz/dictionaries/recipe.dict |
  has "fuzzers' words" '"volcanic-glass = "'
tests/docs/recipe_tables.py $program --write
has 'docs/recipes.md' '| `volcanic-glass` |' <docs/recipes.md
build/release/tests/extremes_heavy_tests random_recipes >"$scratch/random" || { cat "$scratch/random" >&2; exit 1; }
has 'random recipes' '[  PASSED  ]' <"$scratch/random"

cd "$scratch"
small_light="--tolerance 50% --atmosphere molecular"
small="--texture-width 16 $small_light"
bake() { "$program" bake "$@" >/dev/null; }
bake 2018-07-27 $small -o clear.exr
bake 2018-07-27 $small --volcanic-glass 0.5 -o glass.exr
! cmp -s clear.exr glass.exr || { echo "volcanic-glass changes no light" >&2; exit 1; }
echo 'light'
strings -n 8 glass.exr | has 'recipe written' 'volcanic-glass = 0.5'
bake glass.exr -o again.exr
cmp glass.exr again.exr
echo 'recipe read back'
printf '[[atmosphere.region]]\nfrom-latitude = 0\nto-latitude = 90\nvolcanic-glass = 0.5\n' >north.toml
bake 2018-07-27 $small --recipe north.toml -o north.exr
! cmp -s clear.exr north.exr || { echo "volcanic-glass of a region changes no light" >&2; exit 1; }
echo 'recipe of a region'
"$program" bake 2018-07-27 $small --volcanic-glass 11 -o no.exr 2>refused && exit 1
has 'refusal' 'volcanic glass = 11, allowed 0 to 10' <refused

"$program" brightness 2018-07-27 $small_light --json | has 'number in --json' '"planted_mlx"'
PYTHONPATH=$copy/build/release/python /usr/bin/python3 - 2018-07-27 <<'END'
import pickle, sys
import coppermoon
moon = coppermoon.brightness(sys.argv[1], air=coppermoon.Air(atmosphere="molecular"), light=coppermoon.Light(tolerance=0.5))
assert moon.planted_mlx == 1e3 * moon.illuminance_lx
assert coppermoon.Brightness.planted_mlx.__doc__ == "planted illuminance [mlx]"
assert pickle.loads(pickle.dumps(moon)) == moon and "planted_mlx=" in repr(moon)
print("number in Python, and pickled")
END
has 'number in the stub' 'def planted_mlx(self) -> float' <"$copy/build/release/python/coppermoon/__init__.pyi"
"$copy/tests/docs/result_tables.py" "$program" --write
has 'docs/results.md' '| `planted_mlx` | number | mlx | planted illuminance |' <"$copy/docs/results.md"

"$program" night 2018-07-27 --at 'Planted City' | has 'city' 'Planted City: '
bake 2018-07-27 $small --response planted-camera -o camera.exr
! cmp -s clear.exr camera.exr || { echo "planted-camera changes no light" >&2; exit 1; }
echo "camera's response"
printf 'P5\n4 2\n255\n\377\377\377\377\377\377\377\177' >map.pgm
bake 2018-07-27 $small --albedo-map map.pgm --albedo-encoding planted-map -o map.exr
strings -n 8 map.exr | has "map's encoding" "albedo-encoding = 'planted-map'"
"$program" develop clear.exr -o a.ppm >/dev/null
[ "$(head -c 2 a.ppm)" = P6 ] || { echo "a.ppm is no picture" >&2; exit 1; }
"$program" develop --help | has 'output format' '.ppm (planted)'
