# SPDX-License-Identifier: MIT
# Compilers and libraries for Windows on x86-64: MinGW-w64's in Debian, with C++'s threads, and what
# .cmake/windows_dependencies.sh makes. All is linked into the program. For the program and for those libraries.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_VERSION 10)
set(CMAKE_SYSTEM_PROCESSOR AMD64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# Windows' stack is aligned to 16 bytes, GCC's code for vectors of 32 and 64 takes more for granted
set(CMAKE_C_FLAGS_INIT "-D_WIN32_WINNT=0x0A00 -Wa,-muse-unaligned-vector-move")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT}")
# OpenImageIO holds functions of the same fmt, and LibRaw one function twice; the first of each is taken
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -Wl,--allow-multiple-definition")

cmake_path(SET coppermoon_dependencies NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../build/windows/dependencies)
set(CMAKE_FIND_ROOT_PATH ${coppermoon_dependencies})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
set(CMAKE_PREFIX_PATH ${coppermoon_dependencies})
set(ENV{PKG_CONFIG_LIBDIR} ${coppermoon_dependencies}/lib/pkgconfig)
set(PKG_CONFIG_ARGN --static)
set(CMAKE_CROSSCOMPILING_EMULATOR env WINEDEBUG=-all wine)
