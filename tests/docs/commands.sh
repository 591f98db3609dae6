#!/bin/sh
# SPDX-License-Identifier: MIT
# The commands that README.md and docs/ show in blocks of `sh`: those of the README, the first steps and the tutorials run, as
# small as they go; of all others the options are known.
#
#   tests/docs/commands.sh PROGRAM
set -eu
program=$(realpath "$1")
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# shown FILE: its commands, a line each.
shown() {
  awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$1" | sed -e ':a' -e '/\\$/N; s/\\\n *//; ta' |
    sed -n 's/ *#.*//; /^coppermoon /p'
}

# smaller COMMAND: options that make it small, and are later than its own.
smaller() {
  picture="--width 96 --height 64" moon="--texture-width 128 --atmosphere undated --rays 30 --bands 6"
  case $1 in
    still | scene) echo "$picture $moon" ;;
    animate) echo "$picture $moon --from U2 --to U2+5min --frames 2 --shard 1/1" ;;
    bake) echo "$moon" ;;
    night) echo "--danjon-spread off --atmosphere undated --rays 30 --bands 6" ;;
    brightness) echo "--atmosphere undated --rays 30 --bands 6" ;;
  esac
}

count=0
for page in "$root/README.md" "$root"/docs/*.md; do
  case $page in */README.md | */start.md | */animate.md | */povray.md | */chase.md) runs=yes ;; *) runs= ;; esac
  shown "$page" >commands
  while read -r _ command rest; do
    count=$((count + 1))
    if [ -n "$runs" ]; then
      rest="$rest $(smaller "$command")"
      case $rest in *"-o film"* | *"-o textures"*) rm -rf film textures ;; esac
    else
      rest="$rest --help"
    fi
    eval "\"\$program\" $command $rest" >out 2>err </dev/null || {
      echo "$page: coppermoon $command $rest"
      cat err
      exit 1
    }
  done <commands
done
[ "$count" -gt 20 ] || { echo "$count commands found, expected more than 20"; exit 1; }
echo "$count commands"
