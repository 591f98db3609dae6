# SPDX-License-Identifier: MIT
# The whole program, as a user runs it.
function(coppermoon_end_to_end noun)
  coppermoon_test(end_to_end/${noun} ${ARGN})
  add_dependencies(end_to_end_${noun}_test coppermoon_program)
endfunction()

coppermoon_end_to_end(bad_input LINKS texture)
