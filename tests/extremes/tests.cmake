# SPDX-License-Identifier: MIT

# the whole program, while things go wrong around it
add_library(extremes_clock_set_back MODULE extremes/clock_set_back.cpp)
coppermoon_test(extremes/faults LINKS algebra LABELS render)
add_dependencies(extremes_faults_test coppermoon_program extremes_clock_set_back)
target_compile_definitions(extremes_faults_test PRIVATE
  COPPERMOON_CLOCK_SET_BACK="$<TARGET_FILE:extremes_clock_set_back>")

coppermoon_test(extremes/film_faults LINKS algebra LABELS slow TIMEOUT 1500)
add_dependencies(extremes_film_faults_test coppermoon_program)

# all that may be asked for
coppermoon_test(extremes/sweep LINKS algebra texture LABELS sweep TIMEOUT 6000)
target_link_libraries(extremes_sweep_test PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(extremes_sweep_test coppermoon_program)
coppermoon_test(extremes/numbers LINKS shadow)
coppermoon_test(extremes/numbers_of_light LINKS shadow)
coppermoon_test(extremes/numbers_of_scenes LINKS colour texture LABELS files)
coppermoon_test(extremes/invariances LINKS texture)

find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
coppermoon_test(extremes/inputs LINKS verbs)
coppermoon_test(extremes/words LINKS povray_scenes texture LABELS render)
foreach(noun inputs words)
  target_link_libraries(extremes_${noun}_test PRIVATE nlohmann_json::nlohmann_json)
  add_dependencies(extremes_${noun}_test coppermoon_program)
endforeach()
