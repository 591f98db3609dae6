#!/bin/sh
# SPDX-License-Identifier: MIT
# Throws what strangers write at what reads it: tests/fuzz.sh [SECONDS=120] [TARGET ...]
#
# Builds by Clang (package clang), runs each target of tests/fuzz that long from its corpus, two at a time, and prints
# executions and coverage. An input of 16 kB (an image: 4 kB) may take 10 s and 2048 MB of memory, one piece of it 512 MB
# (of an image 8192 MB: OpenImageIO asks for room for 256 rows at once, of a million texels each, and touches what it
# uses). Exits 1 on any crash, hang, leak or excess; the input is then in build/fuzz/found. New inputs gather in
# build/fuzz/corpus.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-120}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- albedo_map exif_date flags frames instant light_file magnitudes photon_sums recipe words
command -v clang++ >/dev/null || { echo "clang++: not found; install the package clang" >&2; exit 1; }
export LSAN_OPTIONS="suppressions=$PWD/.cmake/leaks_of_others.txt:print_suppressions=0"
export ASAN_OPTIONS=quarantine_size_mb=64
cmake --preset fuzzers >/dev/null
cmake --build build/fuzzers --target fuzzers
run_one='
seconds=$0 target=$1 status=0 log=build/fuzz/$1.log length=16384 piece=512
case $target in albedo_map | frames) length=4096 piece=8192 ;; esac
mkdir -p "build/fuzz/corpus/$target" build/fuzz/found
dictionary=build/fuzzers/tests/fuzz/$target.dict  # with the words of all parameters
[ -f "$dictionary" ] || dictionary=tests/fuzz/dictionaries/$target.dict
"build/fuzzers/tests/fuzz/fuzz_$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb="$piece" \
  -max_len=$length -close_fd_mask=3 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" \
  -dict="$dictionary" "build/fuzz/corpus/$target" "tests/fuzz/corpus/$target" \
  >"$log" 2>&1 || status=1
executions=$(sed -n "s/^stat::number_of_executed_units: *//p" "$log")
coverage=$(sed -n "s/.* cov: \([0-9]*\).*/\1/p" "$log" | tail -n 1)
finding=$(grep -m 1 -E "ERROR:|runtime error:" "$log" || echo "nothing found")
printf "| %s | %s | %s | %s |\n" "$target" "${executions:-?}" "${coverage:-?}" "$finding"
[ "$status" = 0 ] || tail -n 60 "$log" >&2
exit "$status"'
printf '| target | executions | edges covered | |\n| --- | ---: | ---: | --- |\n'
mkdir -p build/fuzz
trap 'rm -f /dev/shm/coppermoon_fuzz_*' EXIT  # what a crash leaves there
printf '%s\n' "$@" | xargs -n 1 -P 2 sh -c "$run_one" "$seconds" || exit 1
