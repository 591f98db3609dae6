#!/bin/sh
# SPDX-License-Identifier: MIT
# Everything that is checked beside tests/run.sh, in steps of some ten minutes on two processors: four hours at most. On
# Debian 12, as root or with sudo, from any folder; prints the seconds of each step.
#
# Long steps draw a part of what they check, and say which: the turn, which the count of commits moves on, decides, so that
# all is checked in time. Bounds of a part are those that its own number allows (tests/support/chance.h).
#
#   tests/thorough.sh               all steps
#   tests/thorough.sh --whole STEP …    those named, with nothing left to other turns
#   tests/thorough.sh STEP …        those named
#   tests/thorough.sh --part K/N    every N-th step from the K-th on; K may be any whole number, as a count of commits
#   tests/thorough.sh --list        the steps' names
set -eu
cd "$(dirname "$0")/.."
root=$PWD
processors=$(nproc)
# LeakSanitizer of Clang 14 takes thread-local storage of loaded modules for its own, and crashes at the end of a program
export ASAN_OPTIONS=intercept_tls_get_addr=0
export LSAN_OPTIONS="suppressions=$PWD/.cmake/leaks_of_others.txt:print_suppressions=0" UBSAN_OPTIONS=print_stacktrace=1

steps="compiled_alone quick_in_release heavy_under_sanitizers races tidy fuzzers libraries_thoroughly program_thoroughly
extremes_thoroughly films_and_convergence plans_kept plans_kept_with_regions air_recovered stills_recovered
nights_recovered planted_faults planted_mutations planted_parameter natural_commands other_programs packages measurements
small_examples full_examples sweep portable windows wheels macos"

released() { sh examples/build.sh "$1" packages.tests.debian; }
test_release() { ctest --test-dir build/release --output-on-failure --no-tests=error --parallel "$processors" "$@"; }

# drawn PARTS: says which part of PARTS the step draws. takes I PARTS: whether that is the I-th.
drawn() {
  if [ -n "${COPPERMOON_TURN:-}" ]; then echo "drawn: part $((COPPERMOON_TURN % $1 + 1)) of $1"; else echo "drawn: all"; fi
}
takes() { [ -z "${COPPERMOON_TURN:-}" ] || [ $((COPPERMOON_TURN % $2)) -eq "$1" ]; }

# Each source and each public header by itself: none lives on what another includes. tests/run.sh compiles many at once.
# And the check of what rooms include, tried on planted faults.
compiled_alone() {
  sh examples/build.sh all_verify_interface_header_sets packages.tests.debian
  cmake --preset release -B build/alone -DCMAKE_UNITY_BUILD=OFF
  cmake --build build/alone --target coppermoon_program quick_tests heavy_tests
  test_release -R '^layering/includes_planted$'
}

quick_in_release() {
  released quick_tests
  COPPERMOON_THOROUGH=1 test_release -L '^quick$'
}

# Not the statistics of photons and film_light, which take an hour there; nor what runs POV-Ray.
heavy_under_sanitizers() {
  released coppermoon_program
  cmake --preset sanitizers
  cmake --build build/sanitizers --target coppermoon_program baker_shadow_heavy_tests baker_uses_light_heavy_tests \
    baker_uses_plot_heavy_tests baker_uses_picture_heavy_tests baker_uses_dome_heavy_tests baker_uses_film_heavy_tests baker_uses_night_heavy_tests \
    baker_uses_explore_heavy_tests baker_uses_compare_heavy_tests baker_uses_fit_heavy_tests \
    baker_uses_tradeoff_heavy_tests baker_verbs_flags_heavy_tests \
    baker_verbs_manuals_heavy_tests baker_verbs_recipes_heavy_tests baker_verbs_reports_heavy_tests colour_heavy_tests extremes_heavy_tests
  ctest --test-dir build/sanitizers --output-on-failure --no-tests=error --parallel "$processors" -L '^heavy$' \
    -E '^(baker/shadow/(by_photons|landing_statistics|ring_middles)|baker/uses/film/film_light|end_to_end/|extremes/(faults|words)|povray_scenes/|baker/wrappers/)'
}

races() {
  released coppermoon_test_main
  tests/races.sh
}

tidy() {
  released coppermoon_test_main
  tests/tidy.sh
}

fuzzers() {
  released coppermoon_program
  tests/fuzz.sh 90
}

libraries_thoroughly() {
  released heavy_tests
  COPPERMOON_THOROUGH=1 test_release -L '^heavy$' -R '^(baker|colour|povray_scenes)/'
}

program_thoroughly() {
  released heavy_tests
  COPPERMOON_THOROUGH=1 test_release -L '^heavy$' -R '^end_to_end/'
  test_release -L '^slow_package$'
}

extremes_thoroughly() {
  released heavy_tests
  COPPERMOON_THOROUGH=1 test_release -L '^heavy$' -R '^extremes/'
}

films_and_convergence() {
  released slow_tests
  test_release -L '^slow$' -R '^(end_to_end/film|extremes/film_faults|baker/shadow/convergence|baker/uses/fit/fitted_light|baker/wrappers/python/(umbra|wheel))$'
}

# Every second run.
plans_kept() {
  drawn 2
  released slow_tests
  test_release -L '^slow$' -R '^end_to_end/planned_runs$'
}

# Every second run.
plans_kept_with_regions() {
  drawn 2
  released slow_tests
  test_release -L '^slow$' -R '^end_to_end/planned_regions$'
}

# Every second photograph.
air_recovered() {
  drawn 2
  released slow_tests
  test_release -L '^slow$' -R '^end_to_end/recovery$'
}

# Every third still.
stills_recovered() {
  drawn 3
  released slow_tests
  test_release -L '^slow$' -R '^end_to_end/stills$'
}

# Every second night.
nights_recovered() {
  drawn 2
  released slow_tests
  test_release -L '^slow$' -R '^end_to_end/nights$'
}

# Twenty minutes from nothing, four where it was built before.
planted_faults() {
  released coppermoon_program
  tests/faults.sh
}

# The same build; a mutation takes some ten seconds.
planted_mutations() {
  released coppermoon_program
  tests/mutations.sh
}

planted_parameter() {
  released coppermoon_program
  tests/planted_parameter.sh
}

natural_commands() {
  released coppermoon_program
  tests/natural_commands.sh
}

other_programs() { tests/hand_off.sh; }

# On Debian 12, the next turn on 13.
packages() {
  drawn 2
  if takes 0 2; then tests/packages.sh; fi
  if takes 1 2; then tests/packages.sh trixie; fi
}

portable() { tests/portable.sh; }

# Forty minutes from nothing, where the libraries for Windows are not made yet.
windows() { tests/windows.sh; }

# For one of three Pythons.
wheels() {
  drawn 3
  if takes 0 3; then tests/wheels.sh bookworm; fi
  if takes 1 3; then tests/wheels.sh trixie; fi
  if takes 2 3; then tests/wheels.sh forky; fi
}

macos() {
  released coppermoon_program
  tests/macos.sh
}

# A fifth of ten thousand random recipes.
sweep() {
  drawn 5
  released "coppermoon_program sweep_tests"
  for fifth in 0 1 2 3 4; do
    if takes $fifth 5; then test_release -L '^sweep$' -R "^extremes/sweep/[0-9]*[$fifth$((fifth + 5))]\$"; fi
  done
}

measurements() {
  released coppermoon_program
  cd "$scratch"
  "$root/tests/measurements/photon_convergence.sh" 1e4
  "$root/tests/measurements/term_sizes.sh"
  cd "$root"
}

small_examples() {
  released coppermoon_program
  cd "$scratch"
  small="--texture-width 512 --width 150 --height 100"
  "$root/examples/paper_figures.sh" --photons 2e4 $small
  "$root/examples/tradeoff.sh" --quick
  "$root/examples/plans.sh"
  "$root/examples/rim_of_the_umbra.sh"
  "$root/examples/qualities.sh" 256
  "$root/examples/film.sh" --frames 4
  "$root/examples/gallery/gallery.sh" --width 150 --height 100
  cd "$root"
}

# The film, the next turn all others.
full_examples() {
  drawn 2
  released coppermoon_program
  cd "$scratch"
  if takes 0 2; then "$root/examples/film.sh"; fi
  if takes 1 2; then
    "$root/examples/first_eclipse.sh" --solver literal
    "$root/examples/standard_figures.sh"
    "$root/examples/paper_figures.sh"
    "$root/examples/eclipse_brightness.sh"
    "$root/examples/beside_photographs.sh"
    "$root/examples/gallery/gallery.sh"
  fi
  cd "$root"
}

chosen=$steps
COPPERMOON_TURN=$(git -c safe.directory='*' rev-list --count HEAD 2>/dev/null || echo 0)
case ${1:-} in
--whole)
  shift
  COPPERMOON_TURN= chosen=${*:-$steps}
  ;;
--list)
  printf '%s\n' $steps
  exit
  ;;
--part)
  k=${2%/*} n=${2#*/}
  case $k$n in '' | *[!0-9]*) echo "tests/thorough.sh --part $2: allowed is K/N, as 3/19" >&2; exit 2 ;; esac
  chosen=$(printf '%s\n' $steps | awk -v k="$k" -v n="$n" '(NR - 1) % n == k % n')
  COPPERMOON_TURN=$((k / n))  # a step comes every n-th time
  ;;
?*) chosen=$* ;;
esac
if [ -n "$COPPERMOON_TURN" ]; then export COPPERMOON_TURN; else unset COPPERMOON_TURN; fi
for step in $chosen; do
  printf '%s\n' $steps | grep -qx "$step" || { echo "tests/thorough.sh $step: is no step, allowed are" $steps >&2; exit 2; }
done

. examples/parts.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"; end_parts' EXIT
for step in $chosen; do
  part "$step"
  $step
done
part ''
printf '\n== passed: %s\n' "$(echo $chosen)"
