# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Fails when PROGRAM loads a library whose name matches NONE_OF, directly or through others.
#   cmake -DPROGRAM=<file> -DNONE_OF=<regular expression> -P loads.cmake
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE loaded COMMAND_ERROR_IS_FATAL ANY)
if(NOT loaded MATCHES "libc\\.so")
  message(FATAL_ERROR "${PROGRAM}: ldd lists nothing that is known:\n${loaded}")
elseif(loaded MATCHES "${NONE_OF}")
  message(FATAL_ERROR "${PROGRAM}: loads ${CMAKE_MATCH_0}:\n${loaded}")
endif()
message(STATUS "${PROGRAM} loads\n${loaded}")
