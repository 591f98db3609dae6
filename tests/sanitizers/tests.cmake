# SPDX-License-Identifier: MIT
# The sanitizers themselves are checked: each fault, planted, must end the program that has it.
if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize=(address,undefined|thread)")
  return()
endif()
add_executable(sanitizers_planted sanitizers/planted.cpp)
add_dependencies(quick_tests sanitizers_planted)

# planted(FAULT MESSAGE): caught with that message, and with an exit status that fails a test.
function(planted fault message)
  add_test(NAME sanitizers/planted_${fault}_is_told COMMAND sanitizers_planted ${fault})
  set_tests_properties(sanitizers/planted_${fault}_is_told PROPERTIES LABELS quick PASS_REGULAR_EXPRESSION ${message})
  add_test(NAME sanitizers/planted_${fault}_fails COMMAND sanitizers_planted ${fault})
  set_tests_properties(sanitizers/planted_${fault}_fails PROPERTIES LABELS quick WILL_FAIL TRUE)
endfunction()
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=thread")
  planted(race "ThreadSanitizer: data race")
  return()
endif()
planted(overflow "runtime error: signed integer overflow")
planted(leak "LeakSanitizer: detected memory leaks")
planted(past_the_end "AddressSanitizer: heap-buffer-overflow")
