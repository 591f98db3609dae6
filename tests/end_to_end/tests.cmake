# SPDX-License-Identifier: MIT
# The whole program, as a user runs it.
function(coppermoon_end_to_end noun)
  coppermoon_test(end_to_end/${noun} ${ARGN})
  add_dependencies(end_to_end_${noun}_test coppermoon_program)
endfunction()

coppermoon_end_to_end(bad_input LINKS texture)
coppermoon_end_to_end(orientation LINKS povray_scenes texture LABELS render)
coppermoon_end_to_end(exposure LINKS colour texture LABELS render)
find_package(nlohmann_json REQUIRED)
coppermoon_end_to_end(json LINKS algebra)
target_link_libraries(end_to_end_json_test PRIVATE nlohmann_json::nlohmann_json)
coppermoon_end_to_end(recipes LINKS texture)
coppermoon_end_to_end(scene_folder LINKS texture LABELS render)
coppermoon_end_to_end(brightness LINKS almanac)
target_link_libraries(end_to_end_brightness_test PRIVATE nlohmann_json::nlohmann_json)
<<<<<<< ours
coppermoon_end_to_end(low_moon LINKS povray_scenes texture LABELS render)
=======
coppermoon_end_to_end(terms LINKS algebra)
target_link_libraries(end_to_end_terms_test PRIVATE nlohmann_json::nlohmann_json)
>>>>>>> theirs
