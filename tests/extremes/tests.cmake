# SPDX-License-Identifier: MIT
coppermoon_tests(extremes LINKS coppermoon::colour coppermoon::texture
  QUICK invariances numbers numbers_of_light numbers_of_scenes)
coppermoon_computing_tests(extremes numbers_of_light)
coppermoon_tests(extremes LINKS coppermoon::verbs
  HEAVY faults inputs random_recipes words
  SLOW film_faults)

# a clock that goes backwards, for the faults
add_library(extremes_clock_set_back MODULE extremes/clock_set_back.cpp)
add_dependencies(extremes_heavy_tests extremes_clock_set_back)
target_compile_definitions(extremes_heavy_tests PRIVATE
                           COPPERMOON_CLOCK_SET_BACK="$<TARGET_FILE:extremes_clock_set_back>")

# all that may be asked for: ten thousand recipes and five hundred commands on files, a hundredth a time
coppermoon_test_program(extremes sweep "sweep;sweep_of_files" "coppermoon::texture;nlohmann_json::nlohmann_json")
foreach(hundred RANGE 99)
  add_test(NAME extremes/sweep/${hundred} COMMAND ${program} --gtest_filter=*/${hundred})
  set_tests_properties(extremes/sweep/${hundred} PROPERTIES LABELS sweep TIMEOUT 6000)
endforeach()
