#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the libraries of packages.windows for Windows, statically, in build/windows/dependencies: on Debian 12, from their
# sources, which it fetches from apt's mirror. A library whose line and recipe are as they were is not made again.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
work=$root/build/windows/sources
into=$root/build/windows/dependencies
tools=x86_64-w64-mingw32
processors=$(nproc)
mkdir -p "$work" "$into/lib/pkgconfig" "$into/include" "$into/licences"
export PKG_CONFIG_LIBDIR="$into/lib/pkgconfig"
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -1)

# by_cmake SWITCH …: builds and installs the library in the current folder.
by_cmake() {
  cmake -S . -B made -G Ninja -Wno-dev -DCMAKE_TOOLCHAIN_FILE="$root/.cmake/windows.cmake" -DCMAKE_INSTALL_PREFIX="$into" \
    -DCMAKE_INSTALL_LIBDIR:STRING=lib -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF \
    -DCMAKE_CXX_STANDARD=17 "$@" && cmake --build made && cmake --install made
}

# by_hand LIBRARY SOURCES HEADERS FLAGS WITH: makes libLIBRARY.a of sources without CMake, and installs HEADERS; pkg-config
# has it by the line's name, and WITH, what else is linked.
by_hand() {
  printf '%s\n' $2 | xargs -P "$processors" -I {} sh -euc '
    case $1 in *.c) compiler=gcc standard=gnu99 ;; *) compiler=g++ standard=gnu++17 ;; esac
    '"$tools"'-$compiler-posix -std=$standard -O2 -w -D_WIN32_WINNT=0x0A00 $2 -c "$1" -o "$(echo "$1" | tr / _).o"' - {} "$4 -I$into/include" &&
    $tools-ar rcs "$into/lib/lib$1.a" ./*.o && { [ -z "$3" ] || cp -R $3 "$into/include"; } && told "$name" "-l$1 $5"
}

# told NAME LIBRARIES: a file by which pkg-config finds NAME.
told() {
  cat >"$into/lib/pkgconfig/$1.pc" <<PC
Name: $1
Description: $1
Version: $version
Libs: -L$into/lib $2
Cflags: -I$into/include
PC
}

# with NAME LIBRARIES FLAGS: pkg-config has LIBRARIES and FLAGS too for NAME, whose own file leaves them out.
with() { sed -i "s|^Libs:.*|& $(echo $2)|; s|^Cflags:.*|& $3|" "$into/lib/pkgconfig/$1.pc"; }

made() {
  case $name in
  zlib) by_hand z "$(echo *.c)" "zlib.h zconf.h" "" "" ;;
  lcms2) by_hand lcms2 "$(echo src/*.c)" "include/lcms2.h include/lcms2_plugin.h" -Iinclude "" ;;
  pystring) mkdir pystring && cp pystring.h pystring && by_hand pystring pystring.cpp pystring "" "" ;;
  erfa) by_hand erfa "$(ls src/*.c | grep -vE "/(t_erfa|erfaversion)")" "src/erfa.h src/erfam.h" "" "" ;;
  libnova) by_hand nova "$(ls src/*.c | grep -v julian_day)" src/libnova -Isrc "" ;;
  libxxhash) by_hand xxhash xxhash.c xxhash.h "" "" ;;
  libraw)
    by_hand raw "$(find src -name '*.cpp' | grep -v _ph.cpp)" libraw "-I. -DLIBRAW_NODLL -DUSE_ZLIB -DUSE_JPEG -DUSE_JPEG8" \
      "-ljpeg -lz -lws2_32"
    ;;
  boost)
    cp -R libs/*/include/boost libs/numeric/*/include/boost "$into/include"
    here=libs/thread/src
    by_hand boost_thread "$here/win32/thread.cpp $here/win32/tss_pe.cpp $here/win32/thread_primitives.cpp $here/future.cpp
      libs/chrono/src/chrono.cpp" "" -DBOOST_THREAD_BUILD_LIB ""
    for other in atomic chrono date_time; do ln -sf libboost_thread.a "$into/lib/libboost_$other.a"; done  # CMake asks for them too
    ;;
  expat) cd expat && by_cmake "$@" ;;
  exiv2) by_cmake "$@" && with exiv2 "-lexiv2-xmp -lexpat -lz -lws2_32 -lpsapi" "" ;;
  opencolorio) by_cmake "$@" && told OpenColorIO -lOpenColorIO && with OpenColorIO "-lyaml-cpp -lpystring -lexpat -lImath-3_1" -DOpenColorIO_SKIP_IMPORTS ;;
  openimageio)
    CXXFLAGS=-DOpenColorIO_SKIP_IMPORTS by_cmake "$@" && with OpenImageIO "-lOpenEXR-3_1 -lOpenEXRCore-3_1 -lIlmThread-3_1 -lIex-3_1 -ltiff -lraw -ljpeg -lfreetype -lpng16 -lz
      -lboost_thread $(pkg-config --static --libs OpenColorIO) -lpsapi -lws2_32" -DOIIO_STATIC_DEFINE
    ;;
  *) by_cmake "$@" ;;
  esac
}

grep -v '^#' packages.windows | while read -r name archive sum switches; do
  stamp=$(echo "$name $archive $sum $switches" | cat - "$0" | sha256sum)
  [ "$(cat "$into/licences/$name/.made" 2>/dev/null)" != "$stamp" ] || continue
  echo "== $name"
  file=$work/${archive##*/}
  echo "$sum  $file" | sha256sum --check --status 2>/dev/null ||
    /usr/lib/apt/apt-helper -q -o APT::Sandbox::User=root download-file "${mirror%/}/pool/main/$archive" "$file" "SHA256:$sum" >/dev/null
  rm -rf "${work:?}/$name"
  mkdir "$work/$name"
  tar -xf "$file" -C "$work/$name" --strip-components 1
  version=${archive##*_} version=${version%.orig*} version=${version%+*}
  (cd "$work/$name" && eval "made $switches") >"$work/$name.log" 2>&1 ||
    { tail -30 "$work/$name.log" >&2; echo "$name: could not be made, see $work/$name.log" >&2; exit 1; }
  rm -rf "${into:?}/licences/$name"
  mkdir "$into/licences/$name"
  find "$work/$name" -maxdepth 1 -type f | grep -iE '/(licen[cs]e|copying|copyright)[^/]*$' | xargs -I {} cp {} "$into/licences/$name"
  echo "$stamp" >"$into/licences/$name/.made"
  rm -rf "${work:?}/$name"
done

# Libraries that are headers alone are those of packages.debian; the compiler's own are linked into the program as well.
while read -r package headers cmake; do
  [ -z "$headers" ] || ln -sfn "/usr/include/$headers" "$into/include/$headers"
  [ -z "$cmake" ] || { mkdir -p "$into/share/${cmake%/*}" && ln -sfn "/usr/share/$cmake" "$into/share/$cmake"; }
  cp "/usr/share/doc/$package/copyright" "$into/licences/$package"
done <<LIST
libeigen3-dev eigen3 eigen3/cmake
libglm-dev glm cmake/glm
libkissfft-dev kissfft
libtomlplusplus-dev toml++
nlohmann-json3-dev nlohmann cmake/nlohmann_json
gcc-mingw-w64-base
mingw-w64-common
LIST
mkdir -p "$into/lib/cmake/tomlplusplus"
cat >"$into/lib/cmake/tomlplusplus/tomlplusplusConfig.cmake" <<'CMAKE'
add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)
target_compile_definitions(tomlplusplus::tomlplusplus INTERFACE TOML_HEADER_ONLY=1)
CMAKE
