#!/bin/sh
# SPDX-License-Identifier: MIT
# From a fresh Debian machine to a photograph of an eclipsed Moon, first_eclipse.png in the current folder: installs what
# is missing, builds, renders. Further flags go to `coppermoon still`, as --solver literal for
# photons stepped to the letter of the paper (minutes).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/parts.sh"
"$here/build.sh"
part "picture"
"$here/../build/release/coppermoon" still --recipe "$here/first_eclipse.toml" -o first_eclipse.png "$@"
echo "The picture is $PWD/first_eclipse.png"
