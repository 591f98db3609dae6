# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Of the project's files none stands at the top level but what is listed here, dot files apart. What users leave beside
# them, as pictures, is no file of the project's: git tells which are.
#   cmake -DROOT=<source folder> -P top_level.cmake
set(listed CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE README.md packages.debian
    packages.hand_off.debian packages.hand_off.pypi packages.tests.debian packages.windows packages.windows.debian
    baker colour docs examples povray_scenes tests)
execute_process(COMMAND git -c safe.directory=* ls-files WORKING_DIRECTORY ${ROOT} RESULT_VARIABLE no_git OUTPUT_VARIABLE files
                ERROR_QUIET)
if(no_git)  # an unpacked archive
  file(GLOB found LIST_DIRECTORIES true RELATIVE ${ROOT} ${ROOT}/*)
  list(FILTER found EXCLUDE REGEX "^build|\\.(png|exr|svg|csv|mp4)$")
else()
  string(REPLACE "\n" ";" found "${files}")
  list(TRANSFORM found REPLACE "/.*" "")
  list(REMOVE_DUPLICATES found)
endif()
list(FILTER found EXCLUDE REGEX "^\\.|^$")
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
