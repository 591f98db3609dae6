# SPDX-License-Identifier: MIT
foreach(stage algebra almanac atmosphere eclipse files photons plan request result shadow surface texture uses/light uses/shader uses/plot uses/picture uses/dome uses/film uses/night uses/explore uses/compare uses/fit uses/tradeoff verbs wrappers)
  include(${CMAKE_CURRENT_LIST_DIR}/${stage}/tests.cmake)
endforeach()
