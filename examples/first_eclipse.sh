#!/bin/sh
# SPDX-License-Identifier: MIT
# From a fresh Debian machine to a photograph of an eclipsed Moon: installs what is missing, builds, renders.
# Further flags go to `coppermoon still`, as --photons 1e5 for a quick one.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
"$here/build.sh"
"$here/../build/release/coppermoon" still --recipe "$here/first_eclipse.toml" -o first_eclipse.png "$@"
echo "The picture is $PWD/first_eclipse.png"
