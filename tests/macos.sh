#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles each source of the program for a Mac (aarch64) by the Clang, libc++ and headers of macOS that Zig has, with Debian's
# headers of the libraries. Nothing is linked or run. On Debian 12, with a network for pip; ten minutes on two processors.
set -eu
cd "$(dirname "$0")/.."
build=$PWD/build/macos
mkdir -p "$build/include"
[ -d build/zig ] || python3 -m venv build/zig
build/zig/bin/pip install --quiet ziglang==0.17.0

# Without those of Debian's C library beside them.
for name in Imath OpenColorIO OpenImageIO absl eigen3 erfa.h erfadatextra.h erfaextra.h erfam.h exiv2 fitsio.h fmt glm hwy \
  jerror.h jmorecfg.h jpeglib.h kissfft lcms2.h libnova longnam.h nlohmann oneapi tbb toml++ xxhash.h zconf.h zlib.h \
  x86_64-linux-gnu/jconfig.h x86_64-linux-gnu/tiff.h x86_64-linux-gnu/tiffconf.h x86_64-linux-gnu/tiffio.h \
  x86_64-linux-gnu/tiffvers.h; do
  [ -e "/usr/include/$name" ] || { echo "/usr/include/$name: not there; packages.debian lists what is needed"; exit 1; }
  ln -sfn "/usr/include/$name" "$build/include/${name##*/}"
done
ln -sfn . "$build/include/x86_64-linux-gnu"

# Debian's toml++ 3.3 checks a number that it does not include, and its Exiv2 0.27 has std::auto_ptr; later ones do not.
cat >"$build/c++" <<END
#!/bin/sh
for word; do
  shift
  case \$word in /usr/include* | -I/usr/include*) word=\${word%%/usr/include*}$build/include\${word#*/usr/include} ;; esac
  set -- "\$@" "\$word"
done
exec $PWD/build/zig/bin/python -m ziglang c++ -target aarch64-macos -isystem $build/include -DTOML_DISABLE_ENVIRONMENT_CHECKS \\
  -D_LIBCPP_ENABLE_CXX17_REMOVED_AUTO_PTR "\$@"
END
chmod +x "$build/c++"

cmake -G Ninja -B "$build" -DCMAKE_SYSTEM_NAME=Darwin -DCMAKE_SYSTEM_PROCESSOR=arm64 -DCMAKE_CXX_COMPILER="$build/c++" \
  -DCMAKE_LIBRARY_ARCHITECTURE=x86_64-linux-gnu -DCMAKE_TRY_COMPILE_TARGET_TYPE=STATIC_LIBRARY -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS_RELEASE="-O0 -fno-sanitize=all" -DCMAKE_DISABLE_FIND_PACKAGE_pybind11=ON -DCCACHE=OFF \
  -DCOPPERMOON_TESTS=OFF -DCMAKE_CXX_LINKER_LAUNCHER=true
objects=$(ninja -C "$build" -t targets all | sed -n '/header_sets/d; s/: CXX_COMPILER.*//p')
ninja -C "$build" -k 0 $objects
echo "$(echo "$objects" | grep -c macos_posix) of $(echo "$objects" | wc -l) sources is macOS's own; none failed"
