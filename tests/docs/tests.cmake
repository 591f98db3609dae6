# SPDX-License-Identifier: MIT
# The pages for readers.
set(here ${CMAKE_CURRENT_LIST_DIR})
add_test(NAME docs/links COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${here}/links.cmake)
add_test(NAME docs/figures COMMAND ${here}/figures.py)
if(TARGET coppermoon_program)
  add_test(NAME docs/commands COMMAND ${here}/commands.sh $<TARGET_FILE:coppermoon_program>)
  add_test(NAME docs/recipe_tables COMMAND ${here}/recipe_tables.py $<TARGET_FILE:coppermoon_program>)
  add_test(NAME docs/printed_night COMMAND ${here}/printed_night.py $<TARGET_FILE:coppermoon_program>)
endif()
find_program(MKDOCS mkdocs)
if(MKDOCS)
  add_test(NAME docs/site COMMAND ${MKDOCS} build --strict --quiet -f ${PROJECT_SOURCE_DIR}/.mkdocs.yml
           -d ${PROJECT_BINARY_DIR}/site)
endif()
