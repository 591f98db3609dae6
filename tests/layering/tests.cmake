# SPDX-License-Identifier: MIT
set(here ${CMAKE_CURRENT_LIST_DIR})
add_test(NAME layering/includes COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${here}/includes.cmake)
add_test(NAME layering/includes_planted COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR}
         -DCOPY=${PROJECT_BINARY_DIR}/layering_copy -P ${here}/includes_planted.cmake)
set_tests_properties(layering/includes_planted PROPERTIES LABELS slow)
add_test(NAME layering/rooms_tested COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${here}/rooms_tested.cmake)
add_test(NAME layering/faults_apply COMMAND ${PROJECT_SOURCE_DIR}/tests/faults.sh --apply)
add_test(NAME layering/top_level COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${here}/top_level.cmake)
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format)
if(CLANG_FORMAT)
  add_test(NAME layering/format COMMAND ${here}/format.sh ${CLANG_FORMAT})
  set_tests_properties(layering/format PROPERTIES SKIP_RETURN_CODE 77)
endif()
