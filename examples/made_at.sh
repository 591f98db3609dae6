#!/bin/sh
# SPDX-License-Identifier: MIT
# Ends a page of figures: the commit, the machine and the command that they were made by, on stdout. Pages and pictures
# that were made anew leave the commit as it is; any other change makes it "-dirty".
#
# Given  COMMAND …  or --commit: the commit alone
set -eu
cd "$(dirname "$0")/.."
if commit=$(git rev-parse --short HEAD 2>/dev/null); then
  git diff --quiet HEAD -- ':!*.md' ':!docs/pictures' ':!examples/pictures' ':!examples/*.csv' \
    ':!tests/measurements/*.svg' ':!tests/benchmarks/history.csv' || commit=$commit-dirty
else
  commit="version $(build/release/coppermoon --version | awk '{ print $NF; exit }')"
fi
if [ "${1:-}" = --commit ]; then
  echo "$commit"
  exit
fi
processor=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)
command=$(echo "$*" | sed 's/ *$//')
printf '\nMade at %s, on %s processors (%s)%s.\n' "$commit" "$(nproc)" "${processor:-unknown}" "${command:+, by \`$command\`}"
