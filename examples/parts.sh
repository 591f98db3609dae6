# SPDX-License-Identifier: MIT
# Sourced by scripts that say how long they take. `part NAME` ends the part before it and begins another, `part ''` ends it.
# When the outermost script ends, it prints the seconds of each part on the clock and of all processors, also of parts of
# scripts that it called between two. `end_parts` prints them at once and sets `used_in_all`.
part_name= part_begin= part_used= parts_are_inner=${PART_IS_OPEN:-}
if [ -z "${PART_TIMES:-}" ]; then
  PART_TIMES=$(mktemp)
  export PART_TIMES
  parts_are_mine=yes
fi

# Sets `used` to the processor seconds of all processes that this script has waited for.
processor_seconds() {
  times > "$PART_TIMES.used"  # of a pipe's own shell, were it piped
  used=$(awk 'NR == 2 { split($1, user, /[ms]/); split($2, kernel, /[ms]/)
                        print 60 * (user[1] + kernel[1]) + user[2] + kernel[2] }' "$PART_TIMES.used")
  rm -f "$PART_TIMES.used"
}

part() {
  now=$(date +%s)
  processor_seconds
  [ -z "$part_name" ] || [ -n "$parts_are_inner" ] ||
    echo "$((now - part_begin)) $part_used $used $part_name" | awk '{ wall = $1; spent = $3 - $2
      sub(/^[^ ]+ [^ ]+ [^ ]+ /, ""); printf "%6d s %6.0f s  %s\n", wall, spent, $0 }' >> "$PART_TIMES"
  part_name=$1 part_begin=$now part_used=$used
  export PART_IS_OPEN="${parts_are_inner:-$1}"
  [ -z "$1" ] || printf '\n== %s\n' "$1"
}

end_parts() {
  part ''
  [ -n "${parts_are_mine:-}" ] || return 0
  parts_are_mine=
  printf '\n   clock  processors\n'
  awk '{ clock += $1; used += $3; print } END { printf "%6d s %6d s  in all\n", clock, used }' "$PART_TIMES"
  used_in_all=$(awk '{ used += $3 } END { print used + 0 }' "$PART_TIMES")
  rm -f "$PART_TIMES"
}
trap end_parts EXIT
