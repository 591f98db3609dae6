# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Nothing stands at the top level but what is listed here; dot files and build folders apart.
#   cmake -DROOT=<source folder> -P top_level.cmake
set(listed CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md packages.debian
    packages.hand_off.debian
    baker colour examples povray_scenes tests)
file(GLOB found LIST_DIRECTORIES true RELATIVE ${ROOT} ${ROOT}/*)
list(FILTER found EXCLUDE REGEX "^(\\.|build)")
foreach(name ${found})
  if(NOT name IN_LIST listed)
    message(FATAL_ERROR "${name}: stands at the top level, where only these do: ${listed}")
  endif()
endforeach()
foreach(name CMakeLists.txt baker colour povray_scenes tests)
  if(NOT name IN_LIST found)
    message(FATAL_ERROR "${name}: does not stand at the top level of ${ROOT}")
  endif()
endforeach()
