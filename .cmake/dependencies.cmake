# SPDX-License-Identifier: MIT
# How each library is found that a stage may link, by the name of its target. The build finds all of them. The file is
# installed too, so that an outside project finds the same things the same way: those alone that its components link.
#
# Given  coppermoon_wanted   the targets to be found, or ALL
# Gives  coppermoon_known    the targets that stand here
#        coppermoon_missing  those of the wanted that are not to be had
#
# Debian 12's CMake packages of OpenImageIO and OpenColorIO name folders that do not exist: pkg-config is sound for both.
macro(coppermoon_library target way name)
  list(APPEND coppermoon_known ${target})
  if(("${coppermoon_wanted}" STREQUAL "ALL" OR "${target}" IN_LIST coppermoon_wanted) AND NOT TARGET ${target})
    if("${way}" STREQUAL "PACKAGE")
      find_package(${name} QUIET)
    elseif("${way}" STREQUAL "MODULE")
      find_package(PkgConfig QUIET)
      string(REPLACE "PkgConfig::" "" coppermoon_prefix ${target})
      pkg_check_modules(${coppermoon_prefix} QUIET IMPORTED_TARGET ${name})
    else()
      string(TOUPPER COPPERMOON_${name} coppermoon_prefix)
      find_library(${coppermoon_prefix}_LIBRARY ${name})
      find_path(${coppermoon_prefix}_INCLUDE ${way})
      if(${coppermoon_prefix}_LIBRARY AND ${coppermoon_prefix}_INCLUDE)
        add_library(${target} INTERFACE IMPORTED)
        target_link_libraries(${target} INTERFACE ${${coppermoon_prefix}_LIBRARY})
        target_include_directories(${target} INTERFACE ${${coppermoon_prefix}_INCLUDE})
      endif()
    endif()
    if(NOT TARGET ${target})
      list(APPEND coppermoon_missing ${target})
    endif()
  endif()
endmacro()

set(coppermoon_known)
set(coppermoon_missing)
# target, then PACKAGE and the name of a CMake package, MODULE and pkg-config's name, or a header and a library's name
coppermoon_library(absl::time PACKAGE absl)
coppermoon_library(Eigen3::Eigen PACKAGE Eigen3)
coppermoon_library(fmt::fmt PACKAGE fmt)
coppermoon_library(glm::glm PACKAGE glm)
coppermoon_library(nlohmann_json::nlohmann_json PACKAGE nlohmann_json)
coppermoon_library(TBB::tbb PACKAGE TBB)
coppermoon_library(TBB::tbbmalloc PACKAGE TBB)
coppermoon_library(tomlplusplus::tomlplusplus PACKAGE tomlplusplus)
coppermoon_library(ZLIB::ZLIB PACKAGE ZLIB)
coppermoon_library(PkgConfig::CFITSIO MODULE cfitsio)
coppermoon_library(PkgConfig::ERFA MODULE erfa)
coppermoon_library(PkgConfig::Exiv2 MODULE exiv2)
coppermoon_library(PkgConfig::Highway MODULE libhwy)
coppermoon_library(PkgConfig::JPEG MODULE libjpeg)
coppermoon_library(PkgConfig::LCMS MODULE lcms2)
coppermoon_library(PkgConfig::OpenColorIO MODULE OpenColorIO)
coppermoon_library(PkgConfig::OpenImageIO MODULE OpenImageIO)
coppermoon_library(PkgConfig::TIFF MODULE libtiff-4)
coppermoon_library(PkgConfig::XXHash MODULE libxxhash)
coppermoon_library(coppermoon::libnova libnova/lunar.h nova)
