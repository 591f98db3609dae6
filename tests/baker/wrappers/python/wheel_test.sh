#!/bin/sh
# SPDX-License-Identifier: MIT
# A wheel is made without network, its contents are as its record says, and what it holds bakes a Moon elsewhere.
#
#   tests/baker/wrappers/python/wheel_test.sh CMAKE BUILD PYTHON
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
rm -f "$2"/coppermoon-*.whl
"$1" --build "$2" --target coppermoon_wheel >&2
"$3" -m wheel unpack --dest "$scratch" "$2"/coppermoon-*.whl
cd "$scratch"
PYTHONPATH=$(echo "$scratch"/coppermoon-*) "$3" -c '
import coppermoon
assert coppermoon.__file__.startswith("'"$scratch"'"), coppermoon.__file__
light = coppermoon.Light(bands=4, rays=60)
try:
    coppermoon.bake("2018-07-27T20:21:45Z", width=64, light=light, albedo_map="/dev/null")
except coppermoon.Error as error:  # said by the module that has OpenImageIO, which the wheel holds
    assert "coppermoon_images" not in str(error), error
print(coppermoon.bake("2018-07-27T20:21:45Z", width=64, light=light, albedo_map="built-in"))'
