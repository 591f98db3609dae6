# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Fails unless a program of the library prints the numbers that the command prints.
#   cmake -DPROGRAM=umbra_profile -DCOPPERMOON=coppermoon -P same_numbers.cmake
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COPPERMOON} shadow 2018-07-27T20:21:45Z --atmosphere clear --wavelengths 450,550,650
                --axis-distances 0,2000,4000,5000 OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[0-9][^\n]*,[^\n]*,[^\n]*,[^\n]*" rows "${printed}")
set(compared 0)
foreach(row ${rows})
  if(NOT row MATCHES "^([0-9.]+),([^,]+),([^,]+),([^,]+)$")
    continue()
  endif()
  string(REPLACE "." "[.]" numbers "${CMAKE_MATCH_1},${CMAKE_MATCH_2},[^,]+,${CMAKE_MATCH_3},[^,]+,${CMAKE_MATCH_4},[^,]+")
  if(NOT "\n${commands}" MATCHES "\n${numbers}")
    message(FATAL_ERROR "${row}: is not among what the command prints:\n${commands}")
  endif()
  math(EXPR compared "${compared} + 1")
endforeach()
if(NOT compared EQUAL 4)
  message(FATAL_ERROR "${compared} rows compared, expected 4:\n${printed}")
endif()
