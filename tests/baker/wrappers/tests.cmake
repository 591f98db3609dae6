# SPDX-License-Identifier: MIT
# How the add-on for Blender runs the program, without Blender; also as on Windows.
add_test(NAME baker/wrappers/blender/program COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/blender/program_test.py)

# The Python package, where it is built: each file one entry of ctest, run by the interpreter that it was built for.
if(TARGET coppermoon_python)
  add_custom_target(baker_wrappers_python_heavy_tests DEPENDS coppermoon_python coppermoon_program)
  add_dependencies(heavy_tests baker_wrappers_python_heavy_tests)
  add_dependencies(slow_tests coppermoon_python)
  set(surroundings "PYTHONPATH=${PROJECT_BINARY_DIR}/python;PYTHONDONTWRITEBYTECODE=1;COPPERMOON_TEST_DATA=${PROJECT_SOURCE_DIR}/tests;COPPERMOON_PROGRAM=$<TARGET_FILE:coppermoon_program>")
  foreach(noun behaviour numbers)
    add_test(NAME baker/wrappers/python/${noun} COMMAND ${COPPERMOON_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/python/${noun}_test.py)
    set_tests_properties(baker/wrappers/python/${noun} PROPERTIES LABELS heavy TIMEOUT ${heavy_timeout_s}
                         ENVIRONMENT "${surroundings}")
  endforeach()
  # what the example draws needs matplotlib; its number is asserted too
  add_test(NAME baker/wrappers/python/umbra COMMAND ${COPPERMOON_PYTHON} ${PROJECT_SOURCE_DIR}/examples/python/umbra.py
           ${PROJECT_BINARY_DIR}/umbra.png)
  set_tests_properties(baker/wrappers/python/umbra PROPERTIES LABELS slow TIMEOUT ${slow_timeout_s} ENVIRONMENT "${surroundings}"
                       PASS_REGULAR_EXPRESSION "molecules alone: 1/2[1-6][0-9][0-9] of sunlight")
  add_test(NAME baker/wrappers/python/wheel COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/python/wheel_test.sh ${CMAKE_COMMAND}
           ${PROJECT_BINARY_DIR} ${COPPERMOON_PYTHON})
  set_tests_properties(baker/wrappers/python/wheel PROPERTIES LABELS slow TIMEOUT ${slow_timeout_s})
endif()
