# SPDX-License-Identifier: MIT
# Part of the installation: public headers as outside projects see them, <coppermoon/STAGE/NAME.h>. Among themselves they
# are "STAGE/NAME.h" in the source; installed so, a folder of that name in somebody's own project could come first.
#
# Given  headers    files
#        names      of each, its STAGE/NAME.h
#        rewritten  a folder for them
#        include    where headers go, below the prefix
cmake_policy(VERSION 3.25)
foreach(header name IN ZIP_LISTS headers names)
  file(READ ${header} text)
  string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*\"[^\"]*\"" lines "${text}")
  foreach(line ${lines})
    string(REGEX REPLACE ".*\"(.*)\"" "\\1" included "${line}")
    if(NOT included IN_LIST names)
      message(FATAL_ERROR "${header}: is installed and includes \"${included}\", which is not")
    endif()
    string(REPLACE "\"${included}\"" "\"coppermoon/${included}\"" new_line "${line}")
    string(REPLACE "${line}" "${new_line}" text "${text}")
  endforeach()
  set(old)
  if(EXISTS ${rewritten}/${name})
    file(READ ${rewritten}/${name} old)
  endif()
  if(NOT old STREQUAL text)  # what is the same keeps its time, and what was compiled with it stays
    file(WRITE ${rewritten}/${name} "${text}")
  endif()
  cmake_path(GET name PARENT_PATH folder)
  cmake_path(APPEND include coppermoon ${folder} OUTPUT_VARIABLE to)
  cmake_path(ABSOLUTE_PATH to BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
  file(INSTALL ${rewritten}/${name} DESTINATION ${to})
endforeach()
