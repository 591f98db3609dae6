#!/bin/sh
# SPDX-License-Identifier: MIT
# All figures and pictures of the project anew, as a release does on a quiet machine, in place: `git diff --stat` shows
# what has moved. On Debian 12, as root or with sudo; prints the seconds of each part. A part that failed is begun again by
# its name.
#
#   examples/figures.sh              all parts: 14 hours
#   examples/figures.sh PART …       those named
#   examples/figures.sh --short      all but the long ones: an hour
#   examples/figures.sh --list       the parts: minutes on two processors, and what they write
set -eu
cd "$(dirname "$0")/.."
root=$PWD

# Parts in the order of what readers look at first: those of --short up to three_films take 40 minutes.
list() {
  cat <<'END'
benchmarks             4       tests/benchmarks/history.csv
qualities              3       table of docs/speed.md
film                  10       examples/film.md, its sheet there and in docs
tradeoff               5       examples/tradeoff.md, docs/pictures/tradeoff.svg
eclipse_brightness     4       examples/eclipse_brightness.md
brightness_2000_2050   1       examples/brightness_2000_2050.md, .csv and picture
beside_photographs     2       examples/beside_photographs.md, sheet of docs
rim_of_the_umbra       1       examples/rim_of_the_umbra.md, picture of docs
plans                  1       examples/plans.md
paper_figures          1       examples/paper_figures.md, figure_*.png
first_eclipse          1       first_eclipse.png
standard_figures       1       standard_*.png
gallery                2       gallery_*.png
pictures               3       pictures of README and docs
side_by_side           1       examples/side_by_side.md and picture
three_films            1       examples/three_films.md and picture
term_sizes             4       tests/measurements/term_sizes.md
stability              1       tests/measurements/stability.svg
photon_convergence     7       docs/pictures/photon_convergence.png
extremes              12       tests/measurements/extremes.md, all but random recipes and fuzzers
planned_runs          35 LONG  tests/measurements/planned_runs.md: 100 plans, 20 with regions
extremes_at_length   720 LONG  tests/measurements/extremes.md: ten thousand recipes, an hour of each fuzzer
END
}

# page FILE COMMAND …: what it prints, once it has ended well.
page() {
  file=$1
  shift
  "$@" >"$scratch/page"
  mv "$scratch/page" "$root/$file"
}

# kept FOLDER FILE …: moved there from the scratch folder.
kept() {
  folder=$root/$1
  shift
  mv "$@" "$folder"
}

benchmarks() { "$root/tests/benchmarks/history.py"; }

# Between its marks in docs/speed.md.
qualities() {
  "$root/examples/qualities.sh" >table
  page docs/speed.md awk 'FNR == NR { table = table $0 "\n"; next }
    /^<!-- end -->/ { inside = 0 } !inside
    /^<!-- examples\/qualities.sh -->/ { inside = 1; printf "\n%s\n", table }' table "$root/docs/speed.md"
}

film() {
  page examples/film.md "$root/examples/film.sh"
  oiiotool --nosoftwareattrib film/sheet.png --resize 800x0 --compression jpeg:85 \
    -o "$root/docs/pictures/animate_sheet.jpg"
  mv film/sheet.png "$root/examples/pictures/film_sheet.png"
}

tradeoff() { "$root/examples/tradeoff.sh"; }

eclipse_brightness() { page examples/eclipse_brightness.md "$root/examples/eclipse_brightness.sh"; }

brightness_2000_2050() {
  "$root/examples/brightness_2000_2050.sh"
  kept examples brightness_2000_2050.md brightness_2000_2050.csv
  kept examples/pictures pictures/brightness_2000_2050.png
}

beside_photographs() {
  page examples/beside_photographs.md "$root/examples/beside_photographs.sh"
  kept docs/pictures beside_photographs.jpg
}

rim_of_the_umbra() {
  page examples/rim_of_the_umbra.md "$root/examples/rim_of_the_umbra.sh"
  kept docs/pictures rim_of_the_umbra.jpg
}

plans() { page examples/plans.md "$root/examples/plans.sh"; }

paper_figures() {
  page examples/paper_figures.md "$root/examples/paper_figures.sh"
  kept examples/pictures figure_*.png
}

first_eclipse() {
  "$root/examples/first_eclipse.sh"
  kept examples/pictures first_eclipse.png
}

standard_figures() {
  "$root/examples/standard_figures.sh"
  kept examples/pictures standard_*.png
}

gallery() {
  "$root/examples/gallery/gallery.sh"
  kept examples/pictures gallery_*.png
}

pictures() { "$root/examples/pictures.sh"; }

side_by_side() {
  page examples/side_by_side.md "$root/examples/side_by_side.sh"
  kept examples/pictures side_by_side.png
}

three_films() {
  page examples/three_films.md "$root/examples/three_films.sh"
  kept examples/pictures three_films.png
}

term_sizes() { page tests/measurements/term_sizes.md "$root/tests/measurements/term_sizes.sh"; }

stability() { "$root/tests/measurements/stability.sh"; }

photon_convergence() {
  "$root/tests/measurements/photon_convergence.sh"
  kept docs/pictures photon_convergence.png
}

extremes() { page tests/measurements/extremes.md "$root/tests/measurements/extremes.sh" 0; }

planned_runs() { page tests/measurements/planned_runs.md "$root/tests/measurements/planned_runs.sh"; }

extremes_at_length() { page tests/measurements/extremes.md "$root/tests/measurements/extremes.sh" 100 3600; }

names=$(list | awk '{ print $1 }')
case ${1:-} in
--list)
  list
  exit
  ;;
--short) chosen=$(list | awk '!/ LONG / { print $1 }') ;;
?*) chosen=$* ;;
*) chosen=$(echo "$names" | grep -vx extremes) ;;
esac
for name in $chosen; do
  echo "$names" | grep -qx -e "$name" ||
    { echo "examples/figures.sh $name: is no part, allowed are" $names >&2; exit 2; }
done

. examples/parts.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"; end_parts' EXIT
cd "$scratch"
for name in $chosen; do
  part "$name"
  "$name"
done
part ''
cd "$root"
git --no-pager diff --stat
echo "Prose quotes these figures: README.md, docs/exactness.md, speed.md, air.md, films.md, beside_photographs.md, explore.md"
