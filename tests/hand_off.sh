#!/bin/sh
# SPDX-License-Identifier: MIT
# Gives other programs what coppermoon makes, and checks what they make of it: on Debian 12, as root or with sudo,
# installs what packages.hand_off.debian lists, builds, puts what packages.hand_off.pypi lists into the build folder, and
# runs the tests labelled hand_off; writes docs/tools.md. After the build within ten minutes on two processors.
set -eu
cd "$(dirname "$0")/.."
sh examples/build.sh "coppermoon_program coppermoon_python hand_off_tests hand_off_gltf_write_models hand_off_write_twilight" packages.tests.debian packages.hand_off.debian
ctest --test-dir build/release --label-regex hand_off --output-on-failure --no-tests=error
python3 tests/hand_off/table.py build/release docs/tools.md
