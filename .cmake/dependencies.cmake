# SPDX-License-Identifier: MIT
# What the libraries stand on; installed too, so that an outside project finds the same things the same way.
# Debian 12's CMake packages of OpenImageIO and OpenColorIO name folders that do not exist: pkg-config is sound for both.
include(CMakeFindDependencyMacro)
find_dependency(Threads)
find_dependency(glm)
find_dependency(fmt)
find_dependency(TBB)
find_dependency(PkgConfig)
pkg_check_modules(OpenImageIO REQUIRED QUIET IMPORTED_TARGET GLOBAL OpenImageIO)
pkg_check_modules(OpenColorIO REQUIRED QUIET IMPORTED_TARGET GLOBAL OpenColorIO)
pkg_check_modules(ERFA REQUIRED QUIET IMPORTED_TARGET GLOBAL erfa)
if(NOT TARGET coppermoon::libnova)
  find_library(COPPERMOON_LIBNOVA_LIBRARY nova REQUIRED)
  find_path(COPPERMOON_LIBNOVA_INCLUDE libnova/lunar.h REQUIRED)
  add_library(coppermoon::libnova INTERFACE IMPORTED)
  target_link_libraries(coppermoon::libnova INTERFACE ${COPPERMOON_LIBNOVA_LIBRARY})
  target_include_directories(coppermoon::libnova INTERFACE ${COPPERMOON_LIBNOVA_INCLUDE})
endif()
