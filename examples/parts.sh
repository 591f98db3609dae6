# SPDX-License-Identifier: MIT
# Sourced by scripts that say how long they take. `part NAME` ends the part before it and begins another, `part ''` ends it.
# When the outermost script ends, it prints the seconds of each part, also of those in scripts that it called between two.
part_name= part_begin= parts_are_inner=${PART_IS_OPEN:-}
if [ -z "${PART_TIMES:-}" ]; then
  PART_TIMES=$(mktemp)
  export PART_TIMES
  parts_are_mine=yes
fi

part() {
  now=$(date +%s)
  [ -z "$part_name" ] || [ -n "$parts_are_inner" ] ||
    printf '%6d s  %s\n' $((now - part_begin)) "$part_name" >> "$PART_TIMES"
  part_name=$1 part_begin=$now
  export PART_IS_OPEN="${parts_are_inner:-$1}"
  [ -z "$1" ] || printf '\n== %s\n' "$1"
}

end_parts() {
  part ''
  [ -n "${parts_are_mine:-}" ] || return 0
  printf '\n'
  awk '{ all += $1; print } END { printf "%6d s  in all\n", all }' "$PART_TIMES"
  rm -f "$PART_TIMES"
}
trap end_parts EXIT
